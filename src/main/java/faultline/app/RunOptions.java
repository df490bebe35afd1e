package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.external.ExternalController;
import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.FileTarget;
import faultline.io.MessageText;
import faultline.scenario.Scenario;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Stream;

/**
 * The options of {@code run}.
 *
 * @param file the scenario file
 * @param until the duration that replaces the file's, seconds
 * @param seed the seed that replaces the file's
 * @param mode the thread on which the controller runs
 * @param trace the file for the trace
 * @param image the file for the image of the last frame
 * @param journal the file for the scenario that replays the run
 * @param controller the command of a controller in a child process
 * @param patience how long such a controller may take for an answer, seconds; infinite for no limit
 * @param truth whether such a controller is given the ground truth
 */
record RunOptions(
        Path file,
        OptionalDouble until,
        OptionalLong seed,
        ControllerMode mode,
        Optional<Path> trace,
        Optional<Path> image,
        Optional<Path> journal,
        Optional<String> controller,
        double patience,
        boolean truth) {

    private static final List<String> OPTION_NAMES =
            List.of("--until", "--seed", "--threads", "--trace", "--image", "--journal", "--controller", "--patience");
    private static final List<String> FLAG_NAMES = List.of("--truth");
    private static final BigDecimal MAX_DURATION = new BigDecimal("10000000");

    static RunOptions parse(List<String> arguments) throws UsageException {
        Arguments parsed = new Arguments(arguments, OPTION_NAMES, FLAG_NAMES);
        RunOptions options = new RunOptions(
                parsed.singleFile("run"),
                until(parsed.value("--until")),
                seed(parsed.value("--seed")),
                mode(parsed.value("--threads").orElse("none")),
                parsed.fileOption("--trace"),
                parsed.fileOption("--image"),
                parsed.fileOption("--journal"),
                parsed.value("--controller"),
                patience(parsed.value("--patience")),
                parsed.has("--truth"));
        options.checkFilesDiffer();
        options.checkControllerOptions(parsed);
        return options;
    }

    private static OptionalDouble until(Optional<String> text) throws UsageException {
        if (text.isEmpty()) {
            return OptionalDouble.empty();
        }
        Optional<BigDecimal> seconds = DecimalText.parse(text.get())
                .filter(value -> value.signum() >= 0 && value.compareTo(MAX_DURATION) <= 0);
        return OptionalDouble.of(
                seconds.orElseThrow(() -> new UsageException("--until is " + MessageText.quoted(text.get())
                                + ", allowed is a number from 0 to " + MAX_DURATION + " seconds"))
                        .doubleValue());
    }

    private static double patience(Optional<String> text) throws UsageException {
        if (text.isEmpty()) {
            return ExternalController.Timeouts.DEFAULT.answer();
        }
        if (text.get().equals("none")) {
            return Double.POSITIVE_INFINITY;
        }
        return DecimalText.parse(text.get())
                .filter(value -> value.signum() > 0 && value.compareTo(MAX_DURATION) <= 0)
                .orElseThrow(() -> new UsageException("--patience is " + MessageText.quoted(text.get())
                        + ", allowed is none or a number of seconds above 0, up to " + MAX_DURATION))
                .doubleValue();
    }

    private void checkControllerOptions(Arguments given) throws UsageException {
        for (String option : List.of("--patience", "--truth")) {
            if (controller.isEmpty() && given.has(option)) {
                throw new UsageException(option + " needs --controller COMMAND");
            }
        }
        if (controller.isPresent() && journal.isPresent()) {
            throw new UsageException("--journal is not possible with --controller: a journal does not hold the"
                    + " decisions of a controller outside of the program");
        }
        if (controller.isPresent()
                && given.value("--threads").filter("controller"::equals).isPresent()) {
            throw new UsageException(
                    "--threads is \"controller\", allowed with --controller is none: the child runs by itself");
        }
    }

    private static OptionalLong seed(Optional<String> text) throws UsageException {
        try {
            return text.isEmpty() ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(text.get()));
        } catch (NumberFormatException e) {
            throw new UsageException("--seed is " + MessageText.quoted(text.get()) + ", allowed is a whole number from "
                    + Long.MIN_VALUE + " to " + Long.MAX_VALUE);
        }
    }

    private static ControllerMode mode(String text) throws UsageException {
        return switch (text) {
            case "controller" -> ControllerMode.OWN_THREAD;
            case "none" -> ControllerMode.DIRECT;
            default ->
                throw new UsageException("--threads is " + MessageText.quoted(text) + ", allowed is controller or none"
                        + DidYouMean.hint(text, List.of("controller", "none")));
        };
    }

    private void checkFilesDiffer() throws UsageException {
        List<Path> outputs =
                Stream.of(trace, image, journal).flatMap(Optional::stream).toList();
        if (FileTarget.findConflict(List.of(file), outputs).isPresent()) {
            throw new UsageException("one file is named twice, allowed is another one for each output");
        }
    }

    /** Returns the scenario with these options applied. */
    Scenario applyTo(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        SimulationSetup timed = until.isPresent() ? setup.withDuration(until.getAsDouble()) : setup;
        return scenario.withSetup(seed.isPresent() ? timed.withSeed(seed.getAsLong()) : timed);
    }
}
