package faultline.paint.scene;

import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import faultline.sensor.Fault;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.Stroke;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Paints a sensor: its cone, hatched if the sensor is faulty, a dashed grey outline if it is off; an arc at the
 * reported distance and, if a fault changes it, a dashed arc at the true distance; and its number with the names of its
 * faults.
 */
final class SensorPainter {

    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(1.6);
    private static final Stroke OFF_OUTLINE_STROKE = DrawContext.dashedStroke(1.2, 5, 4);
    private static final Stroke READING_STROKE = DrawContext.solidStroke(3);
    private static final Stroke TRUE_READING_STROKE = DrawContext.dashedStroke(1.8, 4, 3);
    private static final int FILL_ALPHA = 64;
    private static final int FAULTY_ALPHA = 26;
    private static final int HATCH_ALPHA = 150;
    /** Between the arc and the label, pixels. */
    private static final double LABEL_GAP = 4;
    /** The minimum length of a labelled cone, pixels. */
    private static final double MIN_LABELLED_RADIUS = 25;
    /** The maximum number of faults that are named in a label. */
    private static final int MAX_NAMES = 3;
    /** The minimum difference between true and reported distance that is shown, pixels. */
    private static final double MIN_READING_DIFFERENCE = 2;

    private SensorPainter() {}

    static void paintCone(DrawContext context, int index, SensorSnapshot sensor) {
        ScreenSector cone = ScreenSector.of(context.camera(), sensor.sector());
        if (sensor.reported().isOff()) {
            paintOff(context, cone, sensor);
        } else {
            paintOn(context, cone, sensor, context.palette().sensorColours(index));
        }
    }

    /** Paints the cone of a sensor without faults. */
    static void paintCone(DrawContext context, Sector sector, SensorColours colours) {
        ScreenSector cone = ScreenSector.of(context.camera(), sector);
        context.fill(cone.outline(), Palette.withAlpha(colours.fill(), FILL_ALPHA));
        context.draw(cone.outline(), colours.outline(), OUTLINE_STROKE);
    }

    private static void paintOff(DrawContext context, ScreenSector cone, SensorSnapshot sensor) {
        hatch(context, cone, sensor, context.palette().muted());
        context.draw(cone.outline(), context.palette().muted(), OFF_OUTLINE_STROKE);
    }

    private static void paintOn(DrawContext context, ScreenSector cone, SensorSnapshot sensor, SensorColours colours) {
        int alpha = sensor.faults().isEmpty() ? FILL_ALPHA : FAULTY_ALPHA;
        context.fill(cone.outline(), Palette.withAlpha(colours.fill(), alpha));
        hatch(context, cone, sensor, colours.outline());
        context.draw(cone.outline(), colours.outline(), OUTLINE_STROKE);
        sensor.reported()
                .distance()
                .ifPresent(distance -> context.draw(cone.arcAt(distance), colours.outline(), READING_STROKE));
    }

    private static void hatch(DrawContext context, ScreenSector cone, SensorSnapshot sensor, Color colour) {
        Color pale = Palette.withAlpha(colour, HATCH_ALPHA);
        sensor.faults().stream()
                .map(Fault::kind)
                .distinct()
                .forEach(kind -> HatchingPainter.paint(context, cone, kind, pale));
    }

    /**
     * Returns the labels of sensors. Names of faults come before plain numbers, and a number that would overlap a label
     * is omitted.
     */
    static List<SensorLabel> labels(DrawContext context, List<SensorSnapshot> sensors, SceneLabels labels) {
        List<SensorLabel> all = new ArrayList<>();
        for (int i = 0; i < sensors.size(); i++) {
            ScreenSector cone = ScreenSector.of(context.camera(), sensors.get(i).sector());
            if (cone.radius() >= MIN_LABELLED_RADIUS) {
                all.add(createLabel(context, cone, i, sensors.get(i), labels));
            }
        }
        all.sort(Comparator.comparing(SensorLabel::isNumber));
        List<SensorLabel> used = new ArrayList<>();
        for (SensorLabel label : all) {
            if (!label.isNumber()
                    || used.stream().noneMatch(other -> label.box().intersects(other.box()))) {
                used.add(label);
            }
        }
        return used;
    }

    static void paintLabel(DrawContext context, SensorLabel label) {
        context.drawLabel(label.text(), label.box().getCenterX(), label.box().getCenterY(), label.colour());
    }

    /** Paints the arc at the true distance, if a fault changes it; other cones must not cover it. */
    static void paintTrueReading(DrawContext context, SensorSnapshot sensor) {
        if (!sensor.faults().isEmpty()) {
            ScreenSector cone = ScreenSector.of(context.camera(), sensor.sector());
            sensor.truth().distance().stream()
                    .filter(truth -> differsFromReported(cone, truth, sensor))
                    .forEach(truth ->
                            context.draw(cone.arcAt(truth), context.palette().text(), TRUE_READING_STROKE));
        }
    }

    /**
     * Creates a label beyond the arc, at a distance at which its bounding box clears the cone in any direction, or
     * inside the arc if the picture ends there.
     */
    private static SensorLabel createLabel(
            DrawContext context, ScreenSector cone, int index, SensorSnapshot sensor, SceneLabels labels) {
        String state = stateText(sensor, labels);
        String text = (index + 1 + " " + state).strip();
        Rectangle2D size = context.measureText(text);
        Vector2 axis = cone.pointAt(0.5, 1).minus(cone.apex());
        double clear = (Math.abs(axis.x()) * size.getWidth() + Math.abs(axis.y()) * size.getHeight()) / 2;
        Rectangle2D beyond = centred(size, cone.pointAt(0.5, cone.radius() + LABEL_GAP + clear));
        Rectangle2D picture = new Rectangle2D.Double(
                0, 0, context.camera().width(), context.camera().height());
        return new SensorLabel(
                text,
                state.isEmpty(),
                picture.contains(beyond) ? beyond : centred(size, cone.pointAt(0.5, cone.radius() - LABEL_GAP - clear)),
                sensor.reported().isOff()
                        ? context.palette().muted()
                        : context.palette().text());
    }

    private static Rectangle2D centred(Rectangle2D size, Vector2 centre) {
        return new Rectangle2D.Double(
                centre.x() - size.getWidth() / 2, centre.y() - size.getHeight() / 2, size.getWidth(), size.getHeight());
    }

    private static boolean differsFromReported(ScreenSector cone, double truth, SensorSnapshot sensor) {
        return !(Math.abs(sensor.reported().encoded() - truth) * cone.scale() < MIN_READING_DIFFERENCE);
    }

    /**
     * Returns the names of the first faults of a sensor and the number of the others, or that it is switched off; empty
     * if neither applies.
     */
    private static String stateText(SensorSnapshot sensor, SceneLabels labels) {
        List<String> names = sensor.faults().stream()
                .map(fault -> labels.faultName().apply(fault.kind()))
                .distinct()
                .toList();
        String faults = String.join(", ", names.subList(0, Math.min(MAX_NAMES, names.size())))
                + (names.size() > MAX_NAMES ? ", +" + (names.size() - MAX_NAMES) : "");
        return faults.isEmpty() && !sensor.spec().on() ? labels.switchedOff() : faults;
    }

    /** A label of a sensor and its bounding box, pixels; {@code isNumber} if it has no text but the number. */
    record SensorLabel(String text, boolean isNumber, Rectangle2D box, Color colour) {}
}
