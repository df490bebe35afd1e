package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.Setup;
import faultline.scenario.Numbers;
import faultline.scenario.Quoting;
import faultline.scenario.Scenario;
import faultline.scenario.Spelling;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * What {@code run} was asked for.
 *
 * @param file the scenario
 * @param until the duration in place of the file's, seconds
 * @param seed in place of the file's
 * @param mode where the controller runs
 * @param trace where the trace goes
 * @param image where the picture of the last frame goes
 * @param journal where the scenario that replays the run goes
 */
record RunOptions(Path file, OptionalDouble until, OptionalLong seed, ControllerMode mode, Optional<Path> trace, Optional<Path> image,
        Optional<Path> journal) {

    private static final List<String> NAMES = List.of("--until", "--seed", "--threads", "--trace", "--image", "--journal");
    private static final BigDecimal LONGEST = new BigDecimal("10000000");

    static RunOptions of(List<String> arguments) throws UsageException {
        Arguments sorted = new Arguments(arguments, NAMES);
        if (sorted.files().size() != 1) {
            throw new UsageException("run takes one scenario file, not " + (sorted.files().isEmpty() ? "none" : sorted.files().size()));
        }
        RunOptions options = new RunOptions(Arguments.path(sorted.files().get(0)), until(sorted.value("--until")), seed(sorted.value("--seed")),
                mode(sorted.value("--threads").orElse("none")), sorted.file("--trace"), sorted.file("--image"), sorted.file("--journal"));
        options.checkFilesDiffer();
        return options;
    }

    private static OptionalDouble until(Optional<String> text) throws UsageException {
        if (text.isEmpty()) {
            return OptionalDouble.empty();
        }
        Optional<BigDecimal> seconds = Numbers.parse(text.get()).filter(value -> value.signum() >= 0 && value.compareTo(LONGEST) <= 0);
        return OptionalDouble.of(seconds.orElseThrow(
                () -> new UsageException("--until is " + Quoting.quoted(text.get()) + ", allowed is a number from 0 to " + LONGEST
                + " seconds")).doubleValue());
    }

    private static OptionalLong seed(Optional<String> text) throws UsageException {
        try {
            return text.isEmpty() ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(text.get()));
        } catch (NumberFormatException e) {
            throw new UsageException("--seed is " + Quoting.quoted(text.get()) + ", allowed is a whole number from " + Long.MIN_VALUE
                    + " to " + Long.MAX_VALUE);
        }
    }

    private static ControllerMode mode(String text) throws UsageException {
        return switch (text) {
            case "controller" -> ControllerMode.OWN_THREAD;
            case "none" -> ControllerMode.DIRECT;
            default -> throw new UsageException("--threads is " + Quoting.quoted(text) + ", allowed is controller or none"
                    + Spelling.hint(text, List.of("controller", "none")));
        };
    }

    private void checkFilesDiffer() throws UsageException {
        List<Path> all = java.util.stream.Stream.of(Optional.of(file), trace, image, journal).flatMap(Optional::stream)
                .map(path -> path.toAbsolutePath().normalize()).filter(path -> !path.startsWith("/dev")).toList();
        if (all.stream().distinct().count() < all.size()) {
            throw new UsageException("one file is named twice, allowed is another one for each output");
        }
    }

    /** A scenario as these options change it. */
    Scenario applyTo(Scenario scenario) {
        Setup setup = scenario.setup();
        Setup timed = until.isPresent() ? setup.withDuration(until.getAsDouble()) : setup;
        return scenario.withSetup(seed.isPresent() ? timed.withSeed(seed.getAsLong()) : timed);
    }
}
