//! The reference program's output.

use hmac_sha256::Hash;

/// Digest of the reference program's output for `-n 1000 -s 1 -o FILE`.
pub(crate) const OFFICIAL_SHA256: &str =
    "374fe976d9f1d1f831a0a6fadf3339c23bbeca62a7eadd62dc8c8db1fc735357";

/// Returns the digest of `bytes`, as `sha256sum` prints it.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Hash::hash(bytes).iter().map(|b| format!("{b:02x}")).collect()
}
