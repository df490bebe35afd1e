package faultline.scenario.xml;

/**
 * A location in a file; that of an element is the end of its start tag, as XML parsers report it.
 *
 * @param line the line, from 1; 0 for the whole file
 * @param column the column, from 1; 0 for the whole file
 */
public record SourceLocation(int line, int column) implements Comparable<SourceLocation> {

    /** The whole file. */
    public static final SourceLocation NONE = new SourceLocation(0, 0);

    @Override
    public int compareTo(SourceLocation other) {
        return line != other.line ? Integer.compare(line, other.line) : Integer.compare(column, other.column);
    }

    /** Returns the suffix of a file's name: {@code :line:column}, or empty for the whole file. */
    @Override
    public String toString() {
        return line > 0 ? ":" + line + ":" + column : "";
    }
}
