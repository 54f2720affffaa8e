// What a reader answers is kept in this browser: predictions, which are made before they are answered, and the
// chosen answers of quizzes. Each question of the section "Predict" has a field, and what was predicted stands
// beside the measured answer.
"use strict";
(() => {
  const page = location.pathname.split("/").at(-1);
  // A browser may keep nothing.
  const read = key => {
    try {
      return localStorage.getItem(key) ?? "";
    } catch {
      return "";
    }
  };
  const keep = (key, text) => {
    try {
      if (text) localStorage.setItem(key, text);
      else localStorage.removeItem(key);
    } catch {}
  };
  const make = (parent, name, properties) => {
    const element = Object.assign(document.createElement(name), properties);
    parent.append(element);
    return element;
  };

  // Shows a committed prediction below its question and in the fold of its answer.
  const show = (form, answer, text) => {
    form.input.hidden = form.commit.hidden = Boolean(text);
    form.said.hidden = form.change.hidden = !text;
    form.said.textContent = text;
    answer.hidden = !text;
    answer.textContent = `You predicted: ${text}`;
  };

  // Gives a question a field. The prediction is shown in the fold `answered` too.
  function ask(question, answered, number) {
    const key = `cutoff-prediction ${page} ${number}`;
    const form = make(question, "form", { className: "prediction" });
    form.input = make(form, "input", { type: "text", ariaLabel: `Your prediction ${number}`, autocomplete: "off" });
    form.commit = make(form, "button", { type: "submit", textContent: "Commit" });
    form.said = make(form, "output", {});
    form.change = make(form, "button", { type: "button", textContent: "Change" });
    const answer = document.createElement("p");
    answer.className = "predicted";
    answered.querySelector("summary").after(answer);
    form.addEventListener("submit", event => {
      event.preventDefault();
      const text = form.input.value.trim();
      keep(key, text);
      show(form, answer, text);
      if (text) form.change.focus();
    });
    form.change.addEventListener("click", () => {
      form.input.value = read(key);
      show(form, answer, "");
      form.input.focus();
    });
    show(form, answer, read(key));
  }

  // The answer of a quiz that was unfolded last is the chosen one. It is open the next time, and the question is
  // marked, so that a reader sees which questions are left.
  function remember(quiz) {
    const answers = [...quiz.querySelectorAll("details[name]")];
    const key = `cutoff-answer ${page} ${answers[0].getAttribute("name")}`;
    const question = quiz.querySelector("summary");
    const mark = make(question.querySelector("p") ?? question, "span", {});
    const say = chosen => {
      mark.className = chosen.matches(".is-right") ? "chosen is-right" : "chosen";
      mark.textContent = chosen.matches(".is-right") ? "answered" : "answered, not right yet";
    };
    answers.forEach((answer, k) =>
      answer.addEventListener("toggle", () => {
        if (!answer.open) return;
        keep(key, String(k));
        say(answer);
      }),
    );
    const chosen = answers[read(key) || -1];
    if (!chosen) return;
    chosen.open = true;
    say(chosen);
  }

  const questions = document.querySelectorAll("#predict ~ ol:first-of-type > li");
  const answers = document.querySelectorAll("details.prediction");
  if (questions.length === answers.length)
    questions.forEach((question, k) => ask(question, answers[k], k + 1));
  document.querySelectorAll("details.quiz").forEach(remember);
})();
