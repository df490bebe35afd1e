package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.ObstacleOutlines;
import faultline.world.Obstacle;
import java.util.Locale;

/**
 * What a hand that holds a mouse button does to an obstacle: it starts from where the obstacle and the mouse were, and goes where
 * the mouse goes.
 */
sealed interface Drag {

    /** The obstacle as it stood at the start. */
    Obstacle obstacle();

    /** Where the obstacle is wanted while the mouse is over a point of the world. */
    Pose wanted(Vec mouse);

    /** What the hand is changing, in words. */
    String values(Pose wanted);

    /**
     * Moves the obstacle without turning it.
     *
     * @param obstacle as it stood at the start
     * @param grip where the mouse took it, metres
     */
    record Move(Obstacle obstacle, Vec grip) implements Drag {
        @Override
        public Pose wanted(Vec mouse) {
            Vec to = obstacle.pose().position().plus(mouse.minus(grip));
            return new Pose(to.x(), to.y(), obstacle.pose().heading());
        }

        @Override
        public String values(Pose wanted) {
            return String.format(Locale.ROOT, "x %.3f m   y %.3f m", wanted.x(), wanted.y());
        }
    }

    /**
     * Turns the obstacle about its middle.
     *
     * @param obstacle as it stood at the start
     * @param grip where the mouse took it, metres
     */
    record Turn(Obstacle obstacle, Vec grip) implements Drag {
        @Override
        public Pose wanted(Vec mouse) {
            Vec middle = ObstacleOutlines.middle(obstacle);
            double turn = mouse.minus(middle).angle() - grip.minus(middle).angle();
            return ObstacleOutlines.turned(obstacle, turn);
        }

        @Override
        public String values(Pose wanted) {
            return String.format(Locale.ROOT, "heading %.1f\u00b0", Math.toDegrees(Math.IEEEremainder(wanted.heading(), 2 * Math.PI)));
        }
    }
}
