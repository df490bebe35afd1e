package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.MessageText;
import faultline.scenario.Scenario;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

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
 */
record RunOptions(
        Path file,
        OptionalDouble until,
        OptionalLong seed,
        ControllerMode mode,
        Optional<Path> trace,
        Optional<Path> image,
        Optional<Path> journal) {

    private static final List<String> OPTION_NAMES =
            List.of("--until", "--seed", "--threads", "--trace", "--image", "--journal");
    private static final BigDecimal MAX_DURATION = new BigDecimal("10000000");

    static RunOptions parse(List<String> arguments) throws UsageException {
        Arguments parsed = new Arguments(arguments, OPTION_NAMES);
        if (parsed.files().size() != 1) {
            throw new UsageException("run takes one scenario file, not "
                    + (parsed.files().isEmpty() ? "none" : parsed.files().size()));
        }
        RunOptions options = new RunOptions(
                Arguments.parsePath(parsed.files().get(0)),
                until(parsed.value("--until")),
                seed(parsed.value("--seed")),
                mode(parsed.value("--threads").orElse("none")),
                parsed.fileOption("--trace"),
                parsed.fileOption("--image"),
                parsed.fileOption("--journal"));
        options.checkFilesDiffer();
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
        List<Path> all = java.util.stream.Stream.of(Optional.of(file), trace, image, journal)
                .flatMap(Optional::stream)
                .map(path -> path.toAbsolutePath().normalize())
                .filter(path -> !path.startsWith("/dev"))
                .toList();
        if (all.stream().distinct().count() < all.size()) {
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
