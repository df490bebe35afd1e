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

    private PythonTraceback() {}

    /** A line of a program, which is the name of its file and the number of the line from 1. */
    record ProgramLine(String file, String line) {}

    /** Returns the innermost line of the user's own program; empty if the lines are no traceback with one. */
    static Optional<ProgramLine> findOwnLine(List<String> lines) {
        Optional<ProgramLine> own = Optional.empty();
        for (String line : lines) {
            Matcher matcher = PLACE.matcher(line);
            if (matcher.find() && !FOREIGN.matcher(matcher.group(1)).matches()) {
                String file = matcher.group(1).replaceFirst(".*[/\\\\]", "");
                own = Optional.of(new ProgramLine(file, matcher.group(2)));
            }
        }
        return own;
    }
}
