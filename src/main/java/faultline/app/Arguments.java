package faultline.app;

import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.FileNameEncoding;
import faultline.io.LinkResolver;
import faultline.io.MessageText;
import java.io.File;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.Predicate;

/** The arguments of one command: files, and options that each take a value, as {@code --seed 7} or {@code --seed=7}. */
final class Arguments {

    /** What the virtual machine puts in the place of bytes that are not in the encoding of the locale. */
    private static final char REPLACEMENT = '\uFFFD';

    private final List<String> files = new ArrayList<>();
    private final Map<String, List<String>> options = new LinkedHashMap<>();

    /** Parses the arguments of a command with options that take a value. */
    Arguments(List<String> arguments, List<String> known) throws UsageException {
        this(arguments, known, List.of());
    }

    /** Parses the arguments of a command that also takes flags, which are options without a value. */
    Arguments(List<String> arguments, List<String> known, List<String> knownFlags) throws UsageException {
        this(arguments, known, knownFlags, List.of());
    }

    /** Parses the arguments of a command with flags and with options that may be given several times. */
    Arguments(List<String> arguments, List<String> known, List<String> knownFlags, List<String> repeatable)
            throws UsageException {
        HelpRequest.throwIfIn(arguments, known);
        List<String> all = new ArrayList<>(known);
        all.addAll(knownFlags);
        int next = 0;
        while (next < arguments.size()) {
            String argument = arguments.get(next++);
            if (!argument.startsWith("-")) {
                files.add(argument);
                continue;
            }
            String[] parts = argument.split("=", 2);
            requireKnown(parts[0], all);
            if (options.containsKey(parts[0]) && !repeatable.contains(parts[0])) {
                throw new UsageException(parts[0] + " is given twice");
            }
            if (knownFlags.contains(parts[0])) {
                requireNoValue(parts);
                add(parts[0], "");
                continue;
            }
            if (parts.length == 1) {
                requireValue(parts[0], arguments, next);
            }
            add(parts[0], parts.length == 2 ? parts[1] : arguments.get(next++));
        }
    }

    private void add(String option, String value) {
        options.computeIfAbsent(option, first -> new ArrayList<>()).add(value);
    }

    private static void requireKnown(String option, List<String> known) throws UsageException {
        if (!known.contains(option)) {
            throw new UsageException("there is no option " + MessageText.quoted(option) + " here; expected "
                    + (known.isEmpty() ? "none" : String.join(", ", known)) + DidYouMean.hint(option, known)
                    + fileHint(option));
        }
    }

    /** Returns how a file whose name begins like an option is written; empty if there is no such file. */
    private static String fileHint(String argument) {
        try {
            return Files.exists(Path.of(argument))
                    ? "; the file of this name is written " + MessageText.excerpt("./" + argument)
                    : "";
        } catch (InvalidPathException e) {
            return "";
        }
    }

    /** A value that begins like an option can only be written as {@code --option=VALUE}. */
    private static void requireValue(String option, List<String> arguments, int index) throws UsageException {
        if (index == arguments.size()) {
            throw new UsageException(option + " needs a value");
        }
        String value = arguments.get(index);
        if (value.startsWith("--") || HelpRequest.isHelp(value)) {
            throw new UsageException(option + " needs a value, and " + MessageText.quoted(value) + " is an option");
        }
    }

    private static void requireNoValue(String[] parts) throws UsageException {
        if (parts.length == 2) {
            throw new UsageException(parts[0] + " takes no value");
        }
    }

    boolean has(String option) {
        return options.containsKey(option);
    }

    /** Returns the arguments that are not options, in order. */
    List<String> files() {
        return List.copyOf(files);
    }

    /** Returns the one scenario file that a command takes. */
    Path singleFile(String command) throws UsageException {
        return singleFile(command, "scenario file");
    }

    /** Returns the one file of a kind that a command takes. */
    Path singleFile(String command, String kind) throws UsageException {
        if (files.size() != 1) {
            throw new UsageException(
                    command + " takes one " + kind + ", not " + (files.isEmpty() ? "none" : files.size()));
        }
        return parsePath(files.get(0));
    }

    /** Returns the value of an option, or empty if it is not given. */
    Optional<String> value(String option) {
        return values(option).stream().findFirst();
    }

    /** Returns the values of an option in their order; none if it is not given. */
    List<String> values(String option) {
        return options.getOrDefault(option, List.of());
    }

    /** Returns the value of an option as a whole number between two others, or empty if it is not given. */
    OptionalLong whole(String option, long min, long max) throws UsageException {
        Optional<String> text = value(option);
        if (text.isEmpty()) {
            return OptionalLong.empty();
        }
        OptionalLong number = DecimalText.parseWhole(text.get());
        if (number.isEmpty() || number.getAsLong() < min || number.getAsLong() > max) {
            throw UsageException.ofValue(option, text.get(), "a whole number from " + min + " to " + max);
        }
        return number;
    }

    /** Returns the value of an option as a whole number from 1 to a greatest one, or another if it is not given. */
    int positive(String option, int max, int defaultValue) throws UsageException {
        return (int) whole(option, 1, max).orElse(defaultValue);
    }

    /** Returns the value of an option as a number, or empty if it is not given. */
    OptionalDouble number(String option, Predicate<BigDecimal> allowed, String expected) throws UsageException {
        Optional<String> text = value(option);
        if (text.isEmpty()) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(DecimalText.parse(text.get())
                .filter(allowed)
                .orElseThrow(() -> UsageException.ofValue(option, text.get(), expected))
                .doubleValue());
    }

    /** Returns the file that an option names, or empty if it is not given. */
    Optional<Path> fileOption(String option) throws UsageException {
        Optional<String> value = value(option);
        return value.isEmpty() ? Optional.empty() : Optional.of(parsePath(value.get()));
    }

    /** Returns the value of an option that names a file to write. */
    Optional<Path> outputOption(String option) throws UsageException {
        Optional<Path> file = fileOption(option);
        String name = value(option).orElse("");
        if (name.equals("-")) {
            throw UsageException.ofValue(
                    option, name, "the name of a file; standard output is /dev/stdout, and a file named - is ./-");
        }
        // That an existing folder is no file is said when it is opened.
        if ((name.endsWith("/") || name.endsWith(File.separator)) && !Files.isDirectory(file.orElseThrow())) {
            throw UsageException.ofValue(option, name, "the name of a file, which does not end with a slash");
        }
        return file;
    }

    /** Throws an exception if an output would replace an input or another output. */
    static void requireDistinct(List<Path> inputs, List<Path> outputs) throws UsageException {
        Optional<Path> conflict =
                LinkResolver.findConflict(inputs, outputs).or(() -> LinkResolver.findRepeatedPipe(outputs));
        if (conflict.isPresent()) {
            throw new UsageException(
                    "the output " + MessageText.quoted(conflict.get().toString())
                            + " is an input or another output; expected another file");
        }
    }

    /**
     * Converts a name to a path.
     *
     * @throws UsageException if the name is empty, the system does not allow it, or it is not a text
     */
    static Path parsePath(String name) throws UsageException {
        try {
            // The replacement character stands for bytes that are no letters, or for itself in the name of a file.
            if (!name.isEmpty() && (name.indexOf(REPLACEMENT) < 0 || Files.exists(Path.of(name)))) {
                return Path.of(name);
            }
        } catch (InvalidPathException e) {
            // Reported below, like the empty name.
        }
        throw new UsageException(MessageText.quoted(name) + " cannot be the name of a file" + encodingHint(name));
    }

    /**
     * Returns a hint if the encoding of the locale, which is also that of file names and of commands, lacks a letter of
     * the name; otherwise an empty text.
     */
    static String encodingHint(String name) {
        if (name.indexOf(REPLACEMENT) >= 0 && FileNameEncoding.isUnicode()) {
            return " in the encoding of this locale, UTF-8";
        }
        return FileNameEncoding.lacking(name)
                .map(encoding ->
                        " in the encoding of this locale, " + encoding + "; it may be possible with LC_ALL=C.UTF-8")
                .orElse("");
    }
}
