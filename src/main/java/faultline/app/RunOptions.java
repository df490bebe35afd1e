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
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * The options of {@code run}.
 *
 * @param arguments all arguments
 * @param file the scenario file
 * @param changes replaces the duration and the seed of the file if options give others
 * @param mode the thread on which the controller runs
 * @param outputs the files to write
 * @param patience how long a controller in a child process may take for an answer, seconds; infinite for no limit
 */
record RunOptions(
        Arguments arguments,
        Path file,
        UnaryOperator<SimulationSetup> changes,
        ControllerMode mode,
        Map<Output, Path> outputs,
        double patience) {

    /** A file that a run can write. */
    enum Output {
        /** The values of every tick. */
        TRACE,
        /** The last frame. */
        IMAGE,
        /** A scenario that replays the run. */
        JOURNAL;

        private String option() {
            return "--" + name().toLowerCase(Locale.ROOT);
        }
    }

    private static final List<String> OPTION_NAMES =
            List.of("--until", "--seed", "--threads", "--trace", "--image", "--journal", "--controller", "--patience");
    private static final List<String> FLAG_NAMES = List.of("--truth");
    private static final BigDecimal MAX_DURATION = new BigDecimal("10000000");

    static RunOptions parse(List<String> given) throws UsageException {
        Arguments arguments = new Arguments(given, OPTION_NAMES, FLAG_NAMES);
        Path file = arguments.singleFile("run");
        UnaryOperator<SimulationSetup> duration = duration(arguments);
        UnaryOperator<SimulationSetup> seed = seed(arguments);
        RunOptions options = new RunOptions(
                arguments,
                file,
                setup -> seed.apply(duration.apply(setup)),
                mode(arguments.value("--threads").orElse("none")),
                outputs(arguments),
                patience(arguments));
        options.checkFilesDiffer();
        options.checkControllerOptions();
        return options;
    }

    private static UnaryOperator<SimulationSetup> duration(Arguments arguments) throws UsageException {
        Optional<String> text = arguments.value("--until");
        if (text.isEmpty()) {
            return UnaryOperator.identity();
        }
        double seconds = DecimalText.parse(text.get())
                .filter(value -> value.signum() >= 0 && value.compareTo(MAX_DURATION) <= 0)
                .orElseThrow(() -> new UsageException("--until is " + MessageText.quoted(text.get())
                        + ", allowed is a number from 0 to " + MAX_DURATION + " seconds"))
                .doubleValue();
        return setup -> setup.withDuration(seconds);
    }

    private static UnaryOperator<SimulationSetup> seed(Arguments arguments) throws UsageException {
        Optional<String> text = arguments.value("--seed");
        if (text.isEmpty()) {
            return UnaryOperator.identity();
        }
        try {
            long seed = Long.parseLong(text.get());
            return setup -> setup.withSeed(seed);
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

    private static Map<Output, Path> outputs(Arguments arguments) throws UsageException {
        Map<Output, Path> outputs = new EnumMap<>(Output.class);
        for (Output output : Output.values()) {
            arguments.fileOption(output.option()).ifPresent(path -> outputs.put(output, path));
        }
        return outputs;
    }

    private static double patience(Arguments arguments) throws UsageException {
        Optional<String> text = arguments.value("--patience");
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

    private void checkFilesDiffer() throws UsageException {
        if (FileTarget.findConflict(List.of(file), List.copyOf(outputs.values()))
                .isPresent()) {
            throw new UsageException("one file is named twice, allowed is another one for each output");
        }
    }

    private void checkControllerOptions() throws UsageException {
        for (String option : List.of("--patience", "--truth")) {
            if (controller().isEmpty() && arguments.has(option)) {
                throw new UsageException(option + " needs --controller COMMAND");
            }
        }
        if (controller().isPresent() && outputs.containsKey(Output.JOURNAL)) {
            throw new UsageException("--journal is not possible with --controller: a journal does not hold the"
                    + " decisions of a controller outside of the program");
        }
        if (controller().isPresent()
                && arguments.value("--threads").filter("controller"::equals).isPresent()) {
            throw new UsageException(
                    "--threads is \"controller\", allowed with --controller is none: the child runs by itself");
        }
    }

    /** Returns the command of a controller in a child process, if one drives. */
    Optional<String> controller() {
        return arguments.value("--controller");
    }

    /** Returns whether a controller in a child process is given the ground truth. */
    boolean truth() {
        return arguments.has("--truth");
    }

    /** Returns the scenario with these options applied. */
    Scenario applyTo(Scenario scenario) {
        return scenario.withSetup(changes.apply(scenario.setup()));
    }
}
