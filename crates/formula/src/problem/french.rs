//! Messages in French.

use super::{Problem, Sequence, shorten};

pub(super) fn message(problem: &Problem) -> String {
    match problem {
        Problem::Empty => "La formule est vide.".into(),
        Problem::MissingOperand => "Il manque une valeur.".into(),
        Problem::MissingOperator => "Il manque un opérateur entre deux valeurs.".into(),
        Problem::MissingItem(sequence) => format!("Il manque {}.", item(*sequence)),
        Problem::EmptyBrackets => "Il n’y a rien entre ces parenthèses.".into(),
        Problem::Unclosed(closing) => {
            format!("Il manque « {closing} » pour fermer ce qui s’ouvre ici.")
        }
        Problem::Mismatched { expected, found } => {
            format!("« {found} » se trouve à la place de « {expected} ».")
        }
        Problem::Unopened(closing) => format!("« {closing} » ferme ce qui n’a pas été ouvert."),
        Problem::LooseSeparator(mark) => format!("« {mark} » se trouve hors de toute parenthèse."),
        Problem::MisplacedWeight => "Il n’y a pas ici de point qui puisse avoir un poids.".into(),
        Problem::AfterWeight => "Quelque chose suit le poids de ce point.".into(),
        Problem::Unexpected(word) => format!("« {} » n’a pas de sens ici.", shorten(word)),
        Problem::UnclosedText => "Ce texte n’a pas de guillemet fermant.".into(),
        Problem::BadAddress(word) => {
            format!("« {} » n’est pas l’adresse d’une cellule.", shorten(word))
        }
        Problem::OutsideSheet(word) => {
            format!("La cellule « {} » est hors de la feuille.", shorten(word))
        }
        Problem::RangeEnd => "Il manque la dernière cellule de cette plage.".into(),
        Problem::ReferenceInLiteral(word) => {
            format!("« {} » désigne une cellule, or ceci n’est pas une formule.", shorten(word))
        }
        Problem::TooDeep(limit) => format!("L’imbrication dépasse {limit} niveaux."),
    }
}

fn item(sequence: Sequence) -> &'static str {
    match sequence {
        Sequence::Point => "une coordonnée",
        Sequence::Weight => "un poids",
        Sequence::List => "un élément de la liste",
        Sequence::Call => "un argument",
    }
}

pub(super) fn hint(problem: &Problem) -> String {
    match problem {
        Problem::Empty => "Écrire un nombre, un point, une cellule ou une fonction après « = ».",
        Problem::MissingOperand => {
            "Un nombre, un point, une liste, une cellule ou une fonction était attendu."
        }
        Problem::MissingOperator => {
            "Mettre + - * / ^ ou une comparaison, ou un séparateur entre parenthèses."
        }
        Problem::MissingItem(Sequence::Weight) => {
            "Donner le poids, ou ôter la marque qui l’annonce."
        }
        Problem::MissingItem(_) => "Le donner, ou ôter le séparateur.",
        Problem::EmptyBrackets => "Écrire une valeur à grouper, ou les coordonnées d’un point.",
        Problem::Unclosed(_) => "Fermer la parenthèse ou le crochet.",
        Problem::Mismatched { .. } => "Fermer une parenthèse par ) et un crochet par ].",
        Problem::Unopened(_) => "L’ôter, ou ouvrir la parenthèse avant.",
        Problem::LooseSeparator(_) => "Mettre un point entre ( ) et une liste entre [ ].",
        Problem::MisplacedWeight => "Un poids termine un point : (x; y; z | p).",
        Problem::AfterWeight => "Le poids vient en dernier : (x; y; z | p).",
        Problem::Unexpected(_) => "L’ôter, ou mettre le texte entre guillemets : \"texte\".",
        Problem::UnclosedText => {
            "Ajouter le guillemet fermant ; un guillemet dans un texte se double."
        }
        Problem::BadAddress(_) => "Écrire A1, $A1, A$1 ou $A$1.",
        Problem::OutsideSheet(_) => "Les lignes vont jusqu’à 1000000, les colonnes jusqu’à ZZZ.",
        Problem::RangeEnd => {
            "Une plage s’écrit A1:B3 ; un mot-clé ne peut être le nom d’une cellule."
        }
        Problem::ReferenceInLiteral(_) => {
            "Commencer par = pour calculer avec cellules et noms, ou par ' pour en faire un texte."
        }
        Problem::TooDeep(_) => "En calculer une partie dans une cellule à part.",
    }
    .into()
}
