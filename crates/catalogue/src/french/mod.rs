//! The messages of the kernel's family of errors in French.

mod measures;
mod patterns;
mod phrases;

use pforms_kernel::{Error, Fault, Place, limit};

/// The message of an error; what the caller wrote and numbers stay as they are.
pub(crate) fn of_error(error: &Error) -> String {
    match error {
        Error::Shape(fault)
        | Error::Domain(fault)
        | Error::Degenerate(fault)
        | Error::Accuracy(fault) => of_fault(fault),
        Error::Format { what, place: Some(Place { line, column }), message } => {
            format!("{}, ligne {line}, colonne {column} : {}", phrase(what), phrase(message))
        }
        Error::Format { what, message, .. } => format!("{} : {}", phrase(what), phrase(message)),
        Error::Limit { what, bytes, cap } => format!(
            "{}, {} : refusé, le plafond est {}",
            phrase(what),
            limit::readable(*bytes),
            limit::readable(*cap)
        ),
        Error::Stopped => "arrêté de l'extérieur".to_owned(),
    }
}

fn of_fault(Fault { argument, received, expected }: &Fault) -> String {
    format!("{argument} : reçu {}, attendu {}", phrase(received), phrase(expected))
}

/// Turns the phrases of the kernel and the operators into French: a whole one if it is known, else
/// part by part, longest first.
fn phrase(english: &str) -> String {
    if let Some(french) = patterns::translated(english, &phrase) {
        return french;
    }
    PHRASES.iter().fold(english.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// What errors are put together from.
const PHRASES: &[(&str, &str)] = &[
    ("a point where the weight vanishes", "un point où le poids s'annule"),
    ("parameters where the form is finite", "des paramètres où la forme est finie"),
    ("finite poles (read the homogeneous ones, or the direction, instead)", "des pôles finis"),
    (
        "finite numbers (a pole at infinity has weight 0)",
        "des nombres finis (un pôle à l'infini a le poids 0)",
    ),
    (
        "a number other than 0 (0 would keep only the first pole)",
        "un nombre non nul (0 ne garderait que le premier pôle)",
    ),
    (
        "two different axes of a form that has at least two",
        "deux axes différents d'une forme qui en a au moins deux",
    ),
    ("points in dimension", "des points en dimension"),
    (
        "a weight that vanishes or changes sign near",
        "un poids qui s'annule ou change de signe près de",
    ),
    (
        "weights of one sign over the window, 0 to 1 on each axis",
        "des poids d'un seul signe sur la fenêtre, de 0 à 1 sur chaque axe",
    ),
    ("points within", "des points à moins de"),
    ("times the size of the form", "fois la taille de la forme"),
    ("no axis: the form is a point", "aucun axe : la forme est un point"),
    ("at least 1 pole along every axis", "au moins 1 pôle le long de chaque axe"),
    ("at least 1 coordinate", "au moins 1 coordonnée"),
    ("one coordinate for each parameter of the host", "une coordonnée par paramètre de l'hôte"),
    ("(further coordinates must be 0)", "(les coordonnées suivantes doivent être nulles)"),
    ("the parameters of the cage", "les paramètres de la cage"),
    ("each of the axes of", "une fois chacun des axes"),
    ("one for each axis of", "un par axe d'"),
    ("one for each axis", "un par axe"),
    ("one for each form", "un par forme"),
    ("one for each pole", "un par pôle"),
    ("coordinates a pole", "coordonnées par pôle"),
    ("finite numbers", "des nombres finis"),
    ("a finite number", "un nombre fini"),
    ("less than the orders", "moins que les ordres"),
    ("indices below", "des indices inférieurs à"),
    ("the order of the net", "l'ordre du réseau"),
    ("the order of axis", "l'ordre de l'axe"),
    ("the degree", "le degré"),
    ("(the weight last)", "(le poids en dernier)"),
    ("the immersed form would have", "la forme immergée aurait"),
    ("the elevated form would have", "la forme élevée aurait"),
    ("the refined net would have", "le réseau raffiné aurait"),
    ("the elevation matrix would have", "la matrice d'élévation aurait"),
    ("the partition would have", "la partition aurait"),
    ("the product would have", "le produit aurait"),
    ("the result would have", "le résultat aurait"),
    ("the tiling would have", "le pavage aurait"),
    ("the grid would have", "la grille aurait"),
    ("the form would have", "la forme aurait"),
    ("the fit would have", "l'approche aurait"),
    ("halvings", "dichotomies"),
    ("at least", "au moins"),
    ("lists of lengths", "des listes de longueurs"),
    ("lists of one length", "des listes de même longueur"),
    (" in dimension ", " en dimension "),
    (" on axis ", " sur l'axe "),
    (" at pole ", " au pôle "),
    (" in pole ", " dans le pôle "),
    ("coordinate ", "coordonnée "),
    ("forms in ", "des formes en "),
    (" numbers", " nombres"),
    (" values", " valeurs"),
    (" poles", " pôles"),
    (" weights", " poids"),
    ("weight 0", "poids 0"),
    (" for orders ", " pour les ordres "),
    (" for a ", " pour une "),
    (" to ", " à "),
    (" of a ", " d'une "),
    (" and ", " et "),
    (" a p", " une p"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phrases_are_put_together() {
        let error = Error::shape("axis", 3, "0 to 1 for a pS22");
        assert_eq!(of_error(&error), "axis : reçu 3, attendu 0 à 1 pour une pS22");
        let error =
            Error::Limit { what: "the form would have 9×9 poles".into(), bytes: 8, cap: 4 };
        assert_eq!(of_error(&error), "la forme aurait 9×9 pôles, 8 B : refusé, le plafond est 4 B");
    }
}
