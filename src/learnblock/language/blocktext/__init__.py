"""Read and write Block-Text: a hand-written lexer and a recursive-descent parser with recovery."""
