// Predictions are made before they are answered: each question of the section "Predict" has a field. What was
// predicted is kept in this browser, and stands beside the measured answer.
"use strict";
(() => {
  const questions = document.querySelectorAll("#predict ~ ol:first-of-type > li");
  const answers = document.querySelectorAll("details.prediction");
  if (answers.length === 0 || questions.length !== answers.length) return;
  const page = location.pathname.split("/").at(-1);
  const key = number => `cutoff-prediction ${page} ${number}`;
  // A browser may keep nothing.
  const read = number => {
    try {
      return localStorage.getItem(key(number)) ?? "";
    } catch {
      return "";
    }
  };
  const keep = (number, text) => {
    try {
      if (text) localStorage.setItem(key(number), text);
      else localStorage.removeItem(key(number));
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

  questions.forEach((question, k) => {
    const number = k + 1;
    const form = make(question, "form", { className: "prediction" });
    form.input = make(form, "input", { type: "text", ariaLabel: `Your prediction ${number}`, autocomplete: "off" });
    form.commit = make(form, "button", { type: "submit", textContent: "Commit" });
    form.said = make(form, "output", {});
    form.change = make(form, "button", { type: "button", textContent: "Change" });
    const answer = document.createElement("p");
    answer.className = "predicted";
    answers[k].querySelector("summary").after(answer);
    form.addEventListener("submit", event => {
      event.preventDefault();
      const text = form.input.value.trim();
      keep(number, text);
      show(form, answer, text);
      if (text) form.change.focus();
    });
    form.change.addEventListener("click", () => {
      form.input.value = read(number);
      show(form, answer, "");
      form.input.focus();
    });
    show(form, answer, read(number));
  });
})();
