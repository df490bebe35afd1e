package faultline.gui.properties;

import faultline.geometry.Pose;
import faultline.gui.edit.Rounding;
import faultline.paint.scene.ObstacleOutlines;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Aligns several obstacles, or distributes them evenly, by their bounding boxes. */
enum ObstacleArrangement {
    /** Left edges at the leftmost one. */
    LEFT,
    /** Centres on one vertical line. */
    CENTRE_X,
    /** Right edges at the rightmost one. */
    RIGHT,
    /** Upper edges at the uppermost one. */
    TOP,
    /** Centres on one horizontal line. */
    CENTRE_Y,
    /** Lower edges at the lowest one. */
    BOTTOM,
    /** Equal distances between centres along x; the outer two stay. */
    SPREAD_X,
    /** Equal distances between centres along y; the outer two stay. */
    SPREAD_Y;

    private record ObstacleBounds(Obstacle obstacle, Rectangle2D box) {}

    /** Returns the number of obstacles from which on this does anything. */
    int minCount() {
        return this == SPREAD_X || this == SPREAD_Y ? 3 : 2;
    }

    /** Returns the commands that arrange obstacles; those that are in place are omitted. */
    List<Command> commands(List<Obstacle> obstacles) {
        List<Command> moves = new ArrayList<>();
        if (obstacles.size() < minCount()) {
            return moves;
        }
        List<ObstacleBounds> placed = obstacles.stream()
                .map(obstacle -> new ObstacleBounds(
                        obstacle, ObstacleOutlines.worldShape(obstacle).getBounds2D()))
                .sorted(Comparator.comparingDouble(
                        each -> this == SPREAD_Y ? each.box.getCenterY() : each.box.getCenterX()))
                .toList();
        Rectangle2D all = placed.stream()
                .map(ObstacleBounds::box)
                .reduce(Rectangle2D::createUnion)
                .orElseThrow();
        for (int i = 0; i < placed.size(); i++) {
            Obstacle obstacle = placed.get(i).obstacle();
            Pose old = obstacle.pose();
            Pose pose = Rounding.round(
                    old, new Pose(old.x() + shiftX(placed, i, all), old.y() + shiftY(placed, i, all), old.heading()));
            if (!pose.equals(old)) {
                moves.add(new Command.MoveObstacle(obstacle.id(), pose));
            }
        }
        return moves;
    }

    private double shiftX(List<ObstacleBounds> placed, int index, Rectangle2D all) {
        Rectangle2D box = placed.get(index).box();
        return switch (this) {
            case LEFT -> all.getMinX() - box.getMinX();
            case CENTRE_X -> all.getCenterX() - box.getCenterX();
            case RIGHT -> all.getMaxX() - box.getMaxX();
            case SPREAD_X -> spread(placed, index, Rectangle2D::getCenterX);
            default -> 0;
        };
    }

    private double shiftY(List<ObstacleBounds> placed, int index, Rectangle2D all) {
        Rectangle2D box = placed.get(index).box();
        return switch (this) {
            case TOP -> all.getMaxY() - box.getMaxY();
            case CENTRE_Y -> all.getCenterY() - box.getCenterY();
            case BOTTOM -> all.getMinY() - box.getMinY();
            case SPREAD_Y -> spread(placed, index, Rectangle2D::getCenterY);
            default -> 0;
        };
    }

    /** Returns how far a box is from its place between the centres of the first and the last one. */
    private static double spread(List<ObstacleBounds> placed, int index, ToDoubleFunction<Rectangle2D> centre) {
        double first = centre.applyAsDouble(placed.get(0).box());
        double last = centre.applyAsDouble(placed.get(placed.size() - 1).box());
        return first
                + (last - first) * index / (placed.size() - 1)
                - centre.applyAsDouble(placed.get(index).box());
    }
}
