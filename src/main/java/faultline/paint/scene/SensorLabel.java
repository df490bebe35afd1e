package faultline.paint.scene;

import faultline.geometry.Vector2;
import faultline.paint.surface.DrawContext;
import faultline.sensor.Fault;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The label of a sensor and its bounding box, pixels: the number of the sensor, with the name of its first fault and
 * the number of the others.
 *
 * @param isNumber whether there is no text but the number of the sensor
 */
record SensorLabel(String text, boolean isNumber, Rectangle2D box, Color colour) {

    /** Between the arc or the robot and the label, pixels. */
    private static final double GAP = 4;
    /** The minimum length of a labelled cone, pixels. */
    private static final double MIN_LABELLED_RADIUS = 25;
    /** The places within a cone for labels that have no room at its arc, as shares of its length. */
    private static final double[] INNER_PLACES = {0.75, 0.5};

    /** The number of labels after which a further one may cover others, because comparisons take long. */
    private static final int MAX_COMPARED = 100;

    /** What a label must be in and must not cover, pixels. */
    private record Room(Rectangle2D picture, Rectangle2D robot) {
        boolean isFree(Rectangle2D box) {
            return picture.contains(box) && !box.intersects(robot);
        }
    }

    /**
     * Returns the labels of the sensors of a robot. Names of faults come before plain numbers. A label that would cover
     * the robot or the name of a fault gets another place. A number that would overlap another one, or for which there
     * is no place, is omitted.
     */
    static List<SensorLabel> of(DrawContext context, Snapshot world, SceneLabels labels) {
        Room room = new Room(
                new Rectangle2D.Double(
                        0, 0, context.camera().width(), context.camera().height()),
                RobotPainter.bounds(context, world.robot(), world.pose()));
        List<LabelPlaces> all = new ArrayList<>();
        for (int i = 0; i < world.sensors().size(); i++) {
            SensorSnapshot sensor = world.sensors().get(i);
            ScreenSector cone = ScreenSector.of(context.camera(), sensor.sector());
            if (cone.radius() >= MIN_LABELLED_RADIUS) {
                all.add(LabelPlaces.of(context, cone, i, sensor, labels, room));
            }
        }
        all.sort(Comparator.comparing(LabelPlaces::isNumber));
        List<SensorLabel> used = new ArrayList<>();
        all.forEach(label -> label.choose(room, used).ifPresent(used::add));
        return used;
    }

    void paint(DrawContext context) {
        context.drawLabel(text, box.getCenterX(), box.getCenterY(), colour);
    }

    /** A label with the boxes that it may have, the best one first. */
    private record LabelPlaces(String text, boolean isNumber, List<Rectangle2D> boxes, Color colour) {

        /** The index of the box inside the arc, which is used if all have disadvantages. */
        private static final int INSIDE = 1;

        static LabelPlaces of(
                DrawContext context,
                ScreenSector cone,
                int index,
                SensorSnapshot sensor,
                SceneLabels labels,
                Room room) {
            String state = stateText(sensor, labels);
            String text = (index + 1 + " " + state).strip();
            return new LabelPlaces(
                    text,
                    state.isEmpty(),
                    boxes(cone, context.measureText(text), room),
                    sensor.reported().isOff()
                            ? context.palette().muted()
                            : context.palette().text());
        }

        /** Returns the best box that is free; for a fault, one that covers other labels if there is no other one. */
        Optional<SensorLabel> choose(Room room, List<SensorLabel> used) {
            if (isNumber
                    && used.stream()
                            .anyMatch(other -> other.isNumber() && other.box().intersects(boxes.get(0)))) {
                return Optional.empty();
            }
            Optional<Rectangle2D> free = boxes.stream()
                    .filter(room::isFree)
                    .filter(box ->
                            used.size() > MAX_COMPARED || used.stream().noneMatch(other -> box.intersects(other.box())))
                    .findFirst();
            if (free.isEmpty() && !isNumber) {
                free = boxes.stream().filter(room::isFree).findFirst().or(() -> Optional.of(boxes.get(INSIDE)));
            }
            return free.map(box -> new SensorLabel(text, isNumber, box, colour));
        }

        /**
         * Returns boxes beyond the arc, at a distance at which they clear the cone in any direction, inside the arc,
         * nearer to the sensor, and at the edge of the picture, also above and below the robot.
         */
        private static List<Rectangle2D> boxes(ScreenSector cone, Rectangle2D size, Room room) {
            Vector2 axis = cone.pointAt(0.5, 1).minus(cone.apex());
            double clear = (Math.abs(axis.x()) * size.getWidth() + Math.abs(axis.y()) * size.getHeight()) / 2;
            Rectangle2D beyond = centred(size, cone.pointAt(0.5, cone.radius() + GAP + clear));
            List<Rectangle2D> boxes = new ArrayList<>();
            boxes.add(beyond);
            boxes.add(centred(size, cone.pointAt(0.5, cone.radius() - GAP - clear)));
            for (double share : INNER_PLACES) {
                boxes.add(centred(size, cone.pointAt(0.5, share * cone.radius())));
            }
            // The labels of a robot outside of the picture stay there.
            if (room.picture().contains(cone.apex().x(), cone.apex().y())) {
                double x = within(beyond.getX(), room.picture().getWidth() - size.getWidth());
                double y = within(beyond.getY(), room.picture().getHeight() - size.getHeight());
                boxes.add(at(size, x, y));
                boxes.add(at(size, x, room.robot().getMinY() - GAP - size.getHeight()));
                boxes.add(at(size, x, room.robot().getMaxY() + GAP));
            }
            return boxes;
        }

        private static double within(double value, double max) {
            return Math.max(0, Math.min(max, value));
        }

        private static Rectangle2D centred(Rectangle2D size, Vector2 centre) {
            return at(size, centre.x() - size.getWidth() / 2, centre.y() - size.getHeight() / 2);
        }

        private static Rectangle2D at(Rectangle2D size, double x, double y) {
            return new Rectangle2D.Double(x, y, size.getWidth(), size.getHeight());
        }

        /**
         * Returns the name of the first fault of a sensor and the number of its other kinds of fault, or that it is
         * switched off; empty if neither applies.
         */
        private static String stateText(SensorSnapshot sensor, SceneLabels labels) {
            List<Fault> faults = sensor.faults();
            if (faults.isEmpty()) {
                return sensor.spec().on() ? "" : labels.switchedOff();
            }
            String name = labels.faultName().apply(faults.get(0).kind());
            long others = faults.stream().map(Fault::kind).distinct().count() - 1;
            return others > 0 ? name + " +" + others : name;
        }
    }
}
