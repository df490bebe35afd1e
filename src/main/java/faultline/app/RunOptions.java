package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.trace.TraceFormat;
import faultline.external.ControllerChoice;
import faultline.io.DidYouMean;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioLimits;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/**
 * The options of {@code run}.
 *
 * @param arguments all arguments
 * @param file the scenario file
 * @param changes replaces the duration and the seed of the file if options give others
 * @param mode the thread on which the controller runs
 * @param outputs the files to write
 * @param pace the speed, as a multiple of real time; infinite for the maximum speed
 * @param controller replaces the controller of the file unless it is the scenario's
 * @param child the options for a controller in a child process
 */
record RunOptions(
        Arguments arguments,
        Path file,
        UnaryOperator<SimulationSetup> changes,
        ControllerMode mode,
        Map<Output, Path> outputs,
        double pace,
        ControllerChoice controller,
        ControllerOptions child) {

    /** A file that a run can write. */
    enum Output {
        /** The values of every tick. */
        TRACE,
        /** The meaning of the columns of the trace, and its run; has no separate option. */
        TRACE_HEADER,
        /** The last frame. */
        IMAGE,
        /** A scenario that replays the run. */
        JOURNAL,
        /** An animated image of the run. */
        FILM;

        private String option() {
            return "--" + name().toLowerCase(Locale.ROOT);
        }
    }

    private static final List<String> OPTION_NAMES = List.of(
            "--until",
            "--seed",
            "--threads",
            "--trace",
            "--trace-format",
            "--image",
            "--journal",
            "--film",
            "--pace",
            "--controller",
            "--jar",
            "--patience");
    private static final List<String> FLAG_NAMES = List.of("--truth", "--json");
    private static final BigDecimal MIN_PACE = new BigDecimal("0.001");
    private static final BigDecimal MAX_PACE = new BigDecimal("1000000");
    private static final BigDecimal MAX_DURATION = new BigDecimal(ScenarioLimits.MAX_DURATION);

    static RunOptions parse(List<String> given) throws UsageException {
        Arguments arguments = new Arguments(given, OPTION_NAMES, FLAG_NAMES);
        Path file = arguments.singleFile("run");
        UnaryOperator<SimulationSetup> duration = duration(arguments);
        UnaryOperator<SimulationSetup> seed = seed(arguments);
        Optional<String> controller = arguments.value("--controller");
        RunOptions options = new RunOptions(
                arguments,
                file,
                setup -> seed.apply(duration.apply(setup)),
                mode(arguments.value("--threads").orElse("none")),
                outputs(arguments),
                pace(arguments),
                controller.isPresent() ? ControllerOptions.choice(controller.get()) : ControllerChoice.SCENARIO,
                ControllerOptions.parse(arguments, controller.isPresent()));
        options.checkFilesDiffer();
        return options;
    }

    /** Returns what the option {@code --until} makes of a setup. */
    static UnaryOperator<SimulationSetup> duration(Arguments arguments) throws UsageException {
        OptionalDouble seconds = arguments.number(
                "--until",
                value -> value.signum() >= 0 && value.compareTo(MAX_DURATION) <= 0,
                "a number from 0 to " + MAX_DURATION + " seconds");
        return setup -> seconds.isPresent() ? setup.withDuration(seconds.getAsDouble()) : setup;
    }

    private static UnaryOperator<SimulationSetup> seed(Arguments arguments) throws UsageException {
        OptionalLong seed = arguments.whole("--seed", Long.MIN_VALUE, Long.MAX_VALUE);
        return setup -> seed.isPresent() ? setup.withSeed(seed.getAsLong()) : setup;
    }

    private static ControllerMode mode(String text) throws UsageException {
        return switch (text) {
            case "controller" -> ControllerMode.OWN_THREAD;
            case "none" -> ControllerMode.DIRECT;
            default ->
                throw UsageException.ofValue(
                        "--threads", text, "controller or none" + DidYouMean.hint(text, List.of("controller", "none")));
        };
    }

    private static Map<Output, Path> outputs(Arguments arguments) throws UsageException {
        Map<Output, Path> outputs = new EnumMap<>(Output.class);
        for (Output output : Output.values()) {
            if (output != Output.TRACE_HEADER) {
                arguments.outputOption(output.option()).ifPresent(path -> outputs.put(output, path));
            }
        }
        TraceFormat format = traceFormat(arguments);
        Path trace = outputs.get(Output.TRACE);
        if (trace == null && arguments.has("--trace-format")) {
            throw new UsageException("--trace-format needs --trace OUT.csv");
        }
        if (format == TraceFormat.TWO) {
            outputs.put(Output.TRACE_HEADER, trace.resolveSibling(trace.getFileName() + ".json"));
        }
        return outputs;
    }

    private static TraceFormat traceFormat(Arguments arguments) throws UsageException {
        String text = arguments.value("--trace-format").orElse("1");
        return switch (text) {
            case "1" -> TraceFormat.ONE;
            case "2" -> TraceFormat.TWO;
            default -> throw UsageException.ofValue("--trace-format", text, "1 or 2");
        };
    }

    /** Returns which columns the trace has. */
    TraceFormat traceFormat() {
        return outputs.containsKey(Output.TRACE_HEADER) ? TraceFormat.TWO : TraceFormat.ONE;
    }

    private static double pace(Arguments arguments) throws UsageException {
        return arguments
                .number(
                        "--pace",
                        value -> value.compareTo(MIN_PACE) >= 0 && value.compareTo(MAX_PACE) <= 0,
                        "a multiple of real time from " + MIN_PACE + " to " + MAX_PACE)
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Returns notes on outputs whose names are those of other formats. */
    List<String> formatNotes() {
        Optional<String> image = Optional.ofNullable(outputs.get(Output.IMAGE))
                .flatMap(name -> FormatNote.of(name, "a PNG image", List.of("png", "svg")));
        Optional<String> film = Optional.ofNullable(outputs.get(Output.FILM))
                .flatMap(name -> FormatNote.of(name, "a GIF film", List.of("gif")));
        return Stream.of(image, film).flatMap(Optional::stream).toList();
    }

    private void checkFilesDiffer() throws UsageException {
        List<Path> inputs = new ArrayList<>(child.files(List.of(controller)));
        inputs.add(file);
        Arguments.requireDistinct(inputs, List.copyOf(outputs.values()));
    }

    /** Throws an exception if an option does not fit the controller. The controllers of the jars must be known. */
    void checkController() throws UsageException {
        boolean isChild = controller.isCommand();
        if (child.truth() && !isChild) {
            throw new UsageException("--truth needs --controller COMMAND");
        }
        if (isChild && arguments.value("--threads").filter("controller"::equals).isPresent()) {
            throw UsageException.ofValue(
                    "--threads", "controller", "none, because the child process of --controller runs by itself");
        }
    }

    /** Returns whether the summary is one JSON object. */
    boolean json() {
        return arguments.has("--json");
    }

    /** Returns the scenario with these options applied. */
    Scenario applyTo(Scenario scenario) {
        return scenario.withSetup(changes.apply(scenario.setup()));
    }
}
