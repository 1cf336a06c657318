//! Models without a result, by their reasons.

use asperity::ContactError;

/// The models without a result, one message for each reason.
#[must_use]
pub fn by_reason(lacking: &[(String, ContactError)]) -> Vec<String> {
    let mut reasons: Vec<(String, Vec<&str>)> = vec![];
    for (id, reason) in lacking {
        // The reason contains the name of the model, which would separate equal reasons.
        let reason = match reason {
            ContactError::Unsupported { what, .. } => format!(" cannot give {what}"),
            ContactError::Refused { reason, .. } => format!(": {reason}"),
            reason => format!(": {reason}"),
        };
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, ids)) if ids.contains(&id.as_str()) => {}
            Some((_, ids)) => ids.push(id),
            None => reasons.push((reason, vec![id])),
        }
    }
    reasons.into_iter().map(|(reason, ids)| format!("{}{reason}", ids.join(", "))).collect()
}
