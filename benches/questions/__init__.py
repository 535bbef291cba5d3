"""The questions, one per file: `VARIANTS`, `SIZES` and `question(variant, size)`."""
