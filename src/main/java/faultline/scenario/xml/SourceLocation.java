package faultline.scenario.xml;

/**
 * A place in a file. That of an element is the end of its start tag, because that is what an XML parser tells.
 *
 * @param line from 1; 0 where there is no place
 * @param column from 1; 0 where there is no place
 */
public record SourceLocation(int line, int column) implements Comparable<SourceLocation> {

    /** No place: the whole file. */
    public static final SourceLocation NONE = new SourceLocation(0, 0);

    @Override
    public int compareTo(SourceLocation other) {
        return line != other.line ? Integer.compare(line, other.line) : Integer.compare(column, other.column);
    }

    /**
     * The place behind a file's name.
     *
     * @return {@code :line:column}, empty without a place
     */
    @Override
    public String toString() {
        return line > 0 ? ":" + line + ":" + column : "";
    }
}
