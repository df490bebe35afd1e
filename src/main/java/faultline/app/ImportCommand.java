package faultline.app;

import faultline.floorplan.FloorPlan;
import faultline.floorplan.FloorPlanProblem;
import faultline.floorplan.FloorPlanScenario;
import faultline.floorplan.MapDescription;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.io.DecimalText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** {@code import}: makes a scenario from an occupancy-grid map. */
final class ImportCommand {

    private static final List<String> OPTION_NAMES =
            List.of("--out", "--resolution", "--threshold", "--unknown", "--min-cells", "--smooth", "--start");
    private static final String NEGATE = "--negate";
    private static final List<String> IMAGE_OPTIONS = List.of("--resolution", "--threshold", NEGATE);
    private static final int MAX_CELLS = 999_999_999;
    private static final BigDecimal MAX_COORDINATE = new BigDecimal(ScenarioLimits.MAX_COORDINATE);

    private final CommandOutput output;

    ImportCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, OPTION_NAMES, List.of(NEGATE));
        Path map = parsed.singleFile("import", "map or image");
        Path target = parsed.outputOption("--out")
                .orElseThrow(() -> new UsageException("import needs --out FILE, the scenario file to write"));
        FloorPlan.Options options = options(parsed);
        FloorPlan plan = read(map, parsed, options);
        Arguments.requireDistinct(List.of(map, plan.description().image()), List.of(target));
        String name = FloorPlanScenario.nameFor(map);
        Optional<String> start = parsed.value("--start");
        Scenario scenario = start.isPresent()
                ? FloorPlanScenario.create(name, plan, start(start.get()))
                : FloorPlanScenario.create(name, plan, helpfulOptions(map, options));
        scenario.save(target);
        print(target, plan, scenario);
        return ExitCode.SUCCESS;
    }

    /** Returns what may help if the robot has no room in the map. */
    private static String helpfulOptions(Path map, FloorPlan.Options options) {
        String pixels = FloorPlan.isYaml(map)
                ? "resolution, occupied_thresh and negate in the map file"
                : "--resolution, --threshold, --negate";
        return pixels + ", --unknown" + (options.smoothing() > 0 ? ", --smooth" : "") + " or --start";
    }

    private FloorPlan read(Path map, Arguments parsed, FloorPlan.Options options) throws UsageException, IOException {
        if (FloorPlan.isYaml(map)) {
            for (String option : IMAGE_OPTIONS) {
                if (parsed.has(option)) {
                    throw new UsageException(option + " is for an image; " + map + " gives its own");
                }
            }
            FloorPlan plan = FloorPlan.readYaml(map, options);
            FloorPlan.readNotes(map).forEach(note -> output.printError(map + ": " + note));
            return plan;
        }
        return FloorPlan.read(image(map, parsed), options);
    }

    private static MapDescription image(Path map, Arguments parsed) throws UsageException, IOException {
        Optional<String> resolution = parsed.value("--resolution");
        if (resolution.isEmpty()) {
            FloorPlan.checkImage(map);
            throw new UsageException("an image needs --resolution M, the side of a pixel in metres");
        }
        BigDecimal side = number("--resolution", resolution.get(), MapDescription.RESOLUTIONS);
        if (!MapDescription.isResolution(side)) {
            throw UsageException.ofValue("--resolution", resolution.get(), MapDescription.RESOLUTIONS);
        }
        OptionalDouble threshold = parsed.number(
                "--threshold",
                share -> share.signum() >= 0 && share.compareTo(BigDecimal.ONE) <= 0,
                FloorPlanProblem.SHARE.english());
        return MapDescription.of(map, side)
                .withOccupied(parsed.has(NEGATE), threshold.orElse(MapDescription.DEFAULT_OCCUPIED));
    }

    private static FloorPlan.Options options(Arguments parsed) throws UsageException {
        String unknown = parsed.value("--unknown").orElse("free");
        if (!List.of("free", "wall").contains(unknown)) {
            throw UsageException.ofValue("--unknown", unknown, "free or wall");
        }
        int cells = (int) parsed.whole("--min-cells", 0, MAX_CELLS).orElse(1);
        String smoothing = parsed.value("--smooth").orElse("0");
        String allowed = "a number of cells from 0 to " + MAX_COORDINATE;
        BigDecimal bound = number("--smooth", smoothing, allowed);
        if (bound.signum() < 0) {
            throw UsageException.ofValue("--smooth", smoothing, allowed);
        }
        return new FloorPlan.Options(unknown.equals("wall"), cells, bound.doubleValue());
    }

    private static Pose start(String text) throws UsageException {
        String[] parts = text.split(",", -1);
        if (parts.length != 3) {
            throw wrongStart(text);
        }
        double x = startNumber(text, parts[0], NumberRange.COORDINATE).doubleValue();
        double y = startNumber(text, parts[1], NumberRange.COORDINATE).doubleValue();
        return new Pose(x, y, Degrees.toRadians(startNumber(text, parts[2], NumberRange.ANGLE)));
    }

    private static BigDecimal startNumber(String text, String part, NumberRange range) throws UsageException {
        return DecimalText.parse(part).filter(range::contains).orElseThrow(() -> wrongStart(text));
    }

    private static UsageException wrongStart(String text) {
        return UsageException.ofValue(
                "--start",
                text,
                "x,y,heading; x and y " + NumberRange.COORDINATE.rule() + ", heading " + NumberRange.ANGLE.rule());
    }

    private static BigDecimal number(String option, String text, String allowed) throws UsageException {
        return DecimalText.parse(text)
                .filter(value -> value.abs().compareTo(MAX_COORDINATE) <= 0)
                .orElseThrow(() -> UsageException.ofValue(option, text, allowed));
    }

    private void print(Path target, FloorPlan plan, Scenario scenario) {
        Pose start = scenario.setup().start();
        output.println("scenario: " + target);
        output.println("cells: " + plan.grid().width() + " x " + plan.grid().height());
        output.println("solid_cells: " + plan.solid().count());
        output.println("rings: " + plan.rings().size());
        output.println("segments: " + plan.segmentCount());
        output.println("start: " + DecimalText.format(start.x()) + "," + DecimalText.format(start.y()) + ","
                + DecimalText.formatDegrees(start.heading()));
    }
}
