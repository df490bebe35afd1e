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
import java.util.stream.Collectors;

/**
 * Paints one sensor: its cone, hatched where it is faulty and a broken grey outline where it is off; an arc at the
 * distance that it reports and, where a fault makes that wrong, a broken one at the true distance; and its number with
 * the names of its faults.
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
    /** A cone shorter than this on the screen gets no number, pixels. */
    private static final double MIN_LABELLED_RADIUS = 25;
    /** A true and a reported distance nearer than this, pixels, are one. */
    private static final double MIN_READING_DIFFERENCE = 2;

    private SensorPainter() {}

    static void paintCone(DrawContext brush, int index, SensorSnapshot sensor) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sensor.sector());
        if (sensor.reported().isOff()) {
            paintOff(brush, cone, sensor);
        } else {
            paintOn(brush, cone, sensor, brush.palette().sensorColours(index));
        }
    }

    /** Paints the cone of a sensor in order. */
    static void paintCone(DrawContext brush, Sector sector, SensorColours colours) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sector);
        brush.fill(cone.outline(), Palette.withAlpha(colours.fill(), FILL_ALPHA));
        brush.draw(cone.outline(), colours.outline(), OUTLINE_STROKE);
    }

    private static void paintOff(DrawContext brush, ScreenSector cone, SensorSnapshot sensor) {
        hatch(brush, cone, sensor, brush.palette().muted());
        brush.draw(cone.outline(), brush.palette().muted(), OFF_OUTLINE_STROKE);
    }

    private static void paintOn(DrawContext brush, ScreenSector cone, SensorSnapshot sensor, SensorColours colours) {
        int alpha = sensor.faults().isEmpty() ? FILL_ALPHA : FAULTY_ALPHA;
        brush.fill(cone.outline(), Palette.withAlpha(colours.fill(), alpha));
        hatch(brush, cone, sensor, colours.outline());
        brush.draw(cone.outline(), colours.outline(), OUTLINE_STROKE);
        sensor.reported()
                .distance()
                .ifPresent(distance -> brush.draw(cone.arcAt(distance), colours.outline(), READING_STROKE));
    }

    private static void hatch(DrawContext brush, ScreenSector cone, SensorSnapshot sensor, Color colour) {
        Color pale = Palette.withAlpha(colour, HATCH_ALPHA);
        sensor.faults().stream()
                .map(Fault::kind)
                .distinct()
                .forEach(kind -> HatchingPainter.paint(brush, cone, kind, pale));
    }

    /** Paints what must not be hidden by other cones. */
    static void paintLabels(DrawContext brush, int index, SensorSnapshot sensor, SceneLabels words) {
        ScreenSector cone = ScreenSector.of(brush.camera(), sensor.sector());
        if (!sensor.faults().isEmpty()) {
            sensor.truth().distance().stream()
                    .filter(truth -> differsFromReported(cone, truth, sensor))
                    .forEach(truth ->
                            brush.draw(cone.arcAt(truth), brush.palette().text(), TRUE_READING_STROKE));
        }
        if (cone.radius() >= MIN_LABELLED_RADIUS) {
            paintLabel(
                    brush,
                    cone,
                    labelText(index, sensor, words),
                    sensor.reported().isOff()
                            ? brush.palette().muted()
                            : brush.palette().text());
        }
    }

    /**
     * Paints a text beyond the arc, far enough that its box stays clear of the cone in any direction; within the arc
     * where the picture ends.
     */
    private static void paintLabel(DrawContext brush, ScreenSector cone, String text, Color colour) {
        Rectangle2D box = brush.measureText(text);
        Vector2 axis = cone.pointAt(0.5, 1).minus(cone.apex());
        double clear = (Math.abs(axis.x()) * box.getWidth() + Math.abs(axis.y()) * box.getHeight()) / 2;
        Vector2 beyond = cone.pointAt(0.5, cone.radius() + LABEL_GAP + clear);
        boolean fits = new Rectangle2D.Double(
                        0, 0, brush.camera().width(), brush.camera().height())
                .contains(
                        beyond.x() - box.getWidth() / 2,
                        beyond.y() - box.getHeight() / 2,
                        box.getWidth(),
                        box.getHeight());
        Vector2 place = fits ? beyond : cone.pointAt(0.5, cone.radius() - LABEL_GAP - clear);
        brush.drawLabel(text, place.x(), place.y(), colour);
    }

    private static boolean differsFromReported(ScreenSector cone, double truth, SensorSnapshot sensor) {
        return !(Math.abs(sensor.reported().encoded() - truth) * cone.scale() < MIN_READING_DIFFERENCE);
    }

    private static String labelText(int index, SensorSnapshot sensor, SceneLabels words) {
        String faults = sensor.faults().stream()
                .map(fault -> " " + words.faultName().apply(fault.kind()))
                .distinct()
                .collect(Collectors.joining());
        boolean switchedOff = !sensor.spec().on() && faults.isEmpty();
        return (index + 1) + (switchedOff ? " " + words.switchedOff() : faults);
    }
}
