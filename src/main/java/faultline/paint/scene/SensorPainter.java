package faultline.paint.scene;

import faultline.geometry.Sector;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import faultline.sensor.Fault;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.Stroke;

/**
 * Paints a sensor: its cone, hatched if the sensor is faulty, a dashed grey outline if it is off; an arc at the
 * reported distance and, if a fault changes it, a dashed arc at the true distance.
 */
final class SensorPainter {

    private static final Stroke OUTLINE_STROKE = DrawContext.solidStroke(1.6);
    private static final Stroke OFF_OUTLINE_STROKE = DrawContext.dashedStroke(1.2, 5, 4);
    private static final Stroke READING_STROKE = DrawContext.solidStroke(3);
    private static final Stroke TRUE_READING_STROKE = DrawContext.dashedStroke(1.8, 4, 3);
    private static final int FILL_ALPHA = 64;
    private static final int FAULTY_ALPHA = 26;
    private static final int HATCH_ALPHA = 150;
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

    private static boolean differsFromReported(ScreenSector cone, double truth, SensorSnapshot sensor) {
        return !(Math.abs(sensor.reported().encoded() - truth) * cone.scale() < MIN_READING_DIFFERENCE);
    }
}
