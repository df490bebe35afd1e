package faultline.app;

import faultline.external.ControllerChoice;
import faultline.external.ControllerJars;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.io.MessageText;
import faultline.io.ProgramVersion;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.jar.JarFile;

/**
 * The options that go with {@code --controller}; the patience is the time limit for an answer of a controller in a
 * child process, seconds, infinite for no limit.
 */
record ControllerOptions(double patience, boolean truth, List<Path> jars) {

    private static final BigDecimal MAX_PATIENCE = new BigDecimal("10000000");

    /** Reads the options, given whether a controller is chosen. */
    static ControllerOptions parse(Arguments given, boolean hasController) throws UsageException {
        for (String option : List.of("--patience", "--truth")) {
            if (!hasController && given.has(option)) {
                throw new UsageException(option + " needs --controller COMMAND");
            }
        }
        Optional<Path> jar = given.fileOption("--jar");
        if (jar.isPresent() && Files.notExists(jar.get())) {
            throw new UsageException(
                    "--jar is " + MessageText.quoted(jar.get().toString()) + ", and there is no such file");
        }
        if (jar.isPresent() && !Files.isReadable(jar.get())) {
            throw new UsageException("--jar is " + MessageText.quoted(jar.get().toString()) + ", which cannot be read");
        }
        if (jar.isPresent() && !isJar(jar.get())) {
            throw new UsageException("--jar is " + MessageText.quoted(jar.get().toString()) + ", which is not a jar");
        }
        return new ControllerOptions(
                patience(given), given.has("--truth"), jar.stream().toList());
    }

    /**
     * Makes the controllers of {@code --jar} available to a command without {@code --controller}, and returns the jar.
     */
    static List<Path> addJar(Arguments given) throws UsageException {
        List<Path> jars = parse(given, true).jars();
        ControllerJars.use(jars);
        return jars;
    }

    /** Returns the choice of an option {@code --controller}. Its jars are already available to the thread. */
    static ControllerChoice choice(String text) throws UsageException {
        return choice("--controller", text, List.of());
    }

    /** Returns the choice of an option, for which some jars are searched. */
    static ControllerChoice choice(String option, String text, List<Path> jars) throws UsageException {
        if (text.isEmpty()) {
            throw UsageException.ofValue(option, text, "the name of a controller or a command");
        }
        String hint = Arguments.encodingHint(text);
        if (!hint.isEmpty()) {
            throw new UsageException(
                    option + " is " + MessageText.quoted(text) + ", which cannot be the name of a command" + hint);
        }
        return new ControllerChoice(text, jars);
    }

    /** Returns the files that a run with some controllers reads, which no output may replace. */
    List<Path> files(List<ControllerChoice> choices) {
        List<Path> files = new ArrayList<>(jars);
        choices.forEach(choice -> files.addAll(choice.files()));
        return files;
    }

    private static boolean isJar(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (JarFile jar = new JarFile(file.toFile())) {
            return jar.size() > 0;
        } catch (IOException e) {
            return false;
        }
    }

    private static double patience(Arguments given) throws UsageException {
        if (given.value("--patience").filter("none"::equals).isPresent()) {
            return Double.POSITIVE_INFINITY;
        }
        return given.number(
                        "--patience",
                        value -> value.doubleValue() > 0 && value.compareTo(MAX_PATIENCE) <= 0,
                        "none or a number of seconds above 0, up to " + MAX_PATIENCE)
                .orElse(ExternalController.Timeouts.DEFAULT.answer());
    }

    /** Returns how children are treated in the runs of a scenario. */
    ProcessControllerSource.ChildSettings childSettings(String scenario, Consumer<String> errors) {
        return new ProcessControllerSource.ChildSettings(
                ProgramVersion.text(),
                scenario,
                ExternalController.Timeouts.DEFAULT.withAnswer(patience),
                truth,
                errors);
    }
}
