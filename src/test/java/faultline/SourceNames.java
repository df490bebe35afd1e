package faultline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The names of all types in the source, with the text of their files. */
final class SourceNames {

    /** A type in another one. Private ones do not count: a page that names one means a type that is gone. */
    private static final Pattern NESTED =
            Pattern.compile("\\n {4,}(?!private )(?:\\w+ )*(?:class|record|enum|interface) (\\w+)");

    private final Map<String, String> sources = new HashMap<>();

    private SourceNames() {}

    static SourceNames read() throws IOException {
        SourceNames names = new SourceNames();
        try (Stream<Path> files = Files.walk(Path.of("src"))) {
            List<Path> found =
                    files.filter(file -> file.toString().endsWith(".java")).toList();
            for (Path file : found) {
                String name = file.getFileName().toString().replaceFirst("\\.java$", "");
                String text = Files.readString(file);
                names.sources.merge(name, text, String::concat);
                NESTED.matcher(text).results().forEach(nested -> names.sources.putIfAbsent(nested.group(1), text));
            }
        }
        return names;
    }

    /**
     * Tests if there is a type of this name whose file contains all the members' names.
     *
     * @param type the simple name
     * @param members names of members, each after a dot, or empty
     */
    boolean contains(String type, String members) {
        String source = sources.get(type);
        return source != null
                && Pattern.compile("\\.")
                        .splitAsStream(members)
                        .allMatch(member -> source.matches("(?s).*\\b" + member + "\\b.*"));
    }
}
