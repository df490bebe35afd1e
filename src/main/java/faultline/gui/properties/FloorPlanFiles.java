package faultline.gui.properties;

import faultline.floorplan.FloorPlan;
import faultline.floorplan.FloorPlanException;
import faultline.floorplan.FloorPlanScenario;
import faultline.floorplan.MapDescription;
import faultline.geometry.Pose;
import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.io.Message;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Recognises and reads files with floor plans. */
public final class FloorPlanFiles {

    /** The endings of floor plans: a map's YAML file, or an image. */
    public static final List<String> EXTENSIONS = List.of("yaml", "yml", "pgm", "png", "bmp", "gif", "tif", "tiff");

    private FloorPlanFiles() {}

    /** Returns whether a file is a floor plan, by its name; the root of a file system, which has none, is not. */
    public static boolean isFloorPlan(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return EXTENSIONS.stream().anyMatch(ending -> name.endsWith("." + ending));
    }

    /** How an image is read: the side of a pixel, metres, and which pixels are solid from which occupancy on. */
    record ImagePixels(double resolution, boolean whiteIsOccupied, double threshold) {}

    /**
     * A floor plan, the scenario that is made of it, notes on the map file, and a sentence that says that the robot has
     * no room in the plan; empty if it has. Without room, the robot of the scenario is at the origin.
     */
    record ImportedPlan(FloorPlan plan, Scenario scenario, List<Message> notes, String noRoom) {}

    /**
     * Reads a floor plan; takes some time.
     *
     * @param file the map or image
     * @param pixels how an image is read; a YAML file says that itself
     * @param options how the plan is traced
     * @param start the start of the robot; null for the middle of the largest free disc
     */
    static ImportedPlan read(Path file, ImagePixels pixels, FloorPlan.Options options, Pose start) throws IOException {
        FloorPlan plan = FloorPlan.isYaml(file)
                ? FloorPlan.readYaml(file, options)
                : FloorPlan.read(
                        MapDescription.of(file, BigDecimal.valueOf(pixels.resolution()))
                                .withOccupied(pixels.whiteIsOccupied(), pixels.threshold()),
                        options);
        String name = FloorPlanScenario.nameFor(file);
        List<Message> notes = FloorPlan.isYaml(file) ? FloorPlan.readNotes(file) : List.of();
        if (start != null) {
            return new ImportedPlan(plan, FloorPlanScenario.create(name, plan, start), notes, "");
        }
        try {
            return new ImportedPlan(
                    plan, FloorPlanScenario.create(name, plan, helpfulSettings(file, options)), notes, "");
        } catch (FloorPlanException noRoom) {
            Scenario withoutRoom = FloorPlanScenario.create(name, plan, new Pose(0, 0, 0));
            return new ImportedPlan(plan, withoutRoom, notes, ErrorMessages.describeAsSentence(noRoom, file));
        }
    }

    /** Returns what may help if the robot has no room in the plan. */
    private static String helpfulSettings(Path file, FloorPlan.Options options) {
        String start = Messages.get("import.findsStart");
        String outlines = Messages.get("import.unknown");
        if (options.smoothing() > 0) {
            outlines = Messages.get("import.settings.outlines", outlines, Messages.get("import.smoothing"));
        }
        return FloorPlan.isYaml(file)
                ? Messages.get("import.settings.map", start, outlines)
                : Messages.get(
                        "import.settings.image",
                        Messages.get("import.resolution"),
                        Messages.get("import.negate"),
                        Messages.get("import.threshold"),
                        start,
                        outlines);
    }
}
