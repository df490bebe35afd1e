package faultline.gui.properties;

import faultline.floorplan.FloorPlan;
import faultline.floorplan.FloorPlanScenario;
import faultline.geometry.Pose;
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

    /** A floor plan, and the scenario that is made of it. */
    record ImportedPlan(FloorPlan plan, Scenario scenario) {}

    /**
     * Reads a floor plan; takes some time.
     *
     * @param file the map or image
     * @param resolution the side of a pixel of an image, metres; a YAML file gives its own
     * @param options how the plan is traced
     * @param start the start of the robot; null for the middle of the largest free disc
     */
    static ImportedPlan read(Path file, double resolution, FloorPlan.Options options, Pose start) throws IOException {
        FloorPlan plan = FloorPlan.isYaml(file)
                ? FloorPlan.readYaml(file, options)
                : FloorPlan.readImage(file, BigDecimal.valueOf(resolution), options);
        String name = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
        Scenario scenario =
                start == null ? FloorPlanScenario.create(name, plan) : FloorPlanScenario.create(name, plan, start);
        return new ImportedPlan(plan, scenario);
    }
}
