package faultline.external;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The lines that Python writes about an exception, from the outermost call to the innermost. */
final class PythonTraceback {

    private static final Pattern PLACE = Pattern.compile("^\\s*File \"(.+)\", line ([0-9]+)");

    /** The files that no user has written: the client, installed packages, and those that are not on a disk. */
    private static final Pattern FOREIGN =
            Pattern.compile("<.*|(.*[/\\\\])?faultline\\.py|.*[/\\\\](lib[/\\\\]python3|Lib[/\\\\]|site-packages).*");

    private static final Pattern HEADER =
            Pattern.compile("(  \\+ Exception Group )?Traceback \\(most recent call last\\):");

    /** The margin of the lines of a group of exceptions. */
    private static final Pattern MARGIN = Pattern.compile("^ +\\| ");

    private PythonTraceback() {}

    /** A line of a program, which is the name of its file and the number of the line from 1. */
    record ProgramLine(String file, String line) {}

    /** Returns the beginning of some lines up to the exception of the last traceback; empty if there is none. */
    static List<String> beginning(List<String> lines) {
        for (int i = lines.size() - 2; i >= 0; i--) {
            if (HEADER.matcher(lines.get(i)).matches()) {
                int end = i + 1;
                while (end < lines.size() - 1 && withoutMargin(lines.get(end)).startsWith(" ")) {
                    end++;
                }
                return lines.subList(0, end + 1).stream()
                        .map(PythonTraceback::withoutMargin)
                        .toList();
            }
        }
        return List.of();
    }

    /** Returns a line without the margin of a group of exceptions. */
    static String withoutMargin(String line) {
        return MARGIN.matcher(line).replaceFirst("");
    }

    /**
     * Returns the innermost line of the user's own program in the traceback that ends with the last line; empty if
     * there is none.
     */
    static Optional<ProgramLine> findOwnLine(List<String> lines) {
        // The last line is the exception; the calls before it are indented.
        for (int i = lines.size() - 2; i >= 0 && lines.get(i).startsWith(" "); i--) {
            Matcher matcher = PLACE.matcher(lines.get(i));
            if (matcher.find() && !FOREIGN.matcher(matcher.group(1)).matches()) {
                String file = matcher.group(1).replaceFirst(".*[/\\\\]", "");
                return Optional.of(new ProgramLine(file, matcher.group(2)));
            }
        }
        return Optional.empty();
    }
}
