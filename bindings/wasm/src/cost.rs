//! What a cell cost, as text.

use pforms_catalogue::Language;
use serde::Serialize;

/// What a cell cost, ready to be shown.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// `0.12 ms`; empty without a clock.
    pub time: String,
    /// `3 × 3`; empty for what is no form.
    pub orders: String,
    /// `1.2 kB`.
    pub bytes: String,
}

impl Cost {
    pub(crate) fn of(cost: &pforms_sheet::Cost, language: Language) -> Self {
        let orders: Vec<String> = cost.orders.iter().flatten().map(ToString::to_string).collect();
        Self {
            time: cost.seconds.map_or(String::new(), |seconds| localised(time(seconds), language)),
            orders: orders.join(" × "),
            bytes: localised(bytes(cost.bytes), language),
        }
    }
}

fn time(seconds: f64) -> String {
    match seconds * 1e3 {
        ms if ms < 0.1 => "< 0.1 ms".to_owned(),
        ms if ms < 10.0 => format!("{ms:.1} ms"),
        ms if ms < 1000.0 => format!("{ms:.0} ms"),
        ms => format!("{:.1} s", ms / 1e3),
    }
}

fn bytes(count: usize) -> String {
    let count = count as f64;
    match count {
        count if count < 1e3 => format!("{count} B"),
        count if count < 1e6 => format!("{:.1} kB", count / 1e3),
        count if count < 1e9 => format!("{:.1} MB", count / 1e6),
        count => format!("{:.1} GB", count / 1e9),
    }
}

/// French writes a comma, and octets.
fn localised(text: String, language: Language) -> String {
    match language {
        Language::English => text,
        Language::French => text.replace('.', ",").replace('B', "o"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn magnitudes_are_easy_to_read() {
        let cost =
            pforms_sheet::Cost { seconds: Some(0.001_26), orders: Some(vec![3, 12]), bytes: 1234 };
        let english = Cost::of(&cost, Language::English);
        assert_eq!((english.time.as_str(), english.orders.as_str()), ("1.3 ms", "3 × 12"));
        assert_eq!(english.bytes, "1.2 kB");
        assert_eq!(Cost::of(&cost, Language::French).bytes, "1,2 ko");
        assert_eq!([time(1e-6), time(0.2), time(12.34)], ["< 0.1 ms", "200 ms", "12.3 s"]);
        assert_eq!([bytes(0), bytes(999), bytes(2_500_000)], ["0 B", "999 B", "2.5 MB"]);
    }
}
