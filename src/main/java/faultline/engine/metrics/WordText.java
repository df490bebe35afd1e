package faultline.engine.metrics;

/** Appends the words of a column, and copies one that is the same object as in the row before. */
final class WordText {

    private String word;
    /** The block in which the text of the last word is; -1 for none. */
    private int block = -1;

    private int start;
    private int end;

    /** Appends a cell. */
    @SuppressWarnings("ReferenceEquality") // A copy of an equal word would cost as much as to compare it.
    void appendCell(String newWord, TraceBlock row) {
        int newStart = row.length();
        if (newWord == word && block == row.number()) {
            row.repeat(start, end);
        } else {
            word = newWord;
            block = row.number();
            row.append(newWord);
        }
        start = newStart;
        end = row.length();
        row.endCell();
    }
}
