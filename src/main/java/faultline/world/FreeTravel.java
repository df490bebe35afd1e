package faultline.world;

import faultline.geometry.BoxDistance;
import faultline.geometry.OrientedBox;

/**
 * The distance that the body can still move without touching a static obstacle. While a tick's motion is within this
 * distance, no contact is tested. Confined to the simulation thread.
 *
 * <p>Two bounds are stored. The bound for the circle about the body holds for any rotation. The bound for the body
 * itself allows less translation and rotation, but also applies nearer to obstacles.
 */
final class FreeTravel {

    /** The distance around the body within which obstacles are searched, metres. */
    private static final double LOOK_AHEAD = 0.5;

    /** The safety margin, metres: far above rounding errors. */
    private static final double MARGIN = 1e-6;

    private final ObstacleSet obstacles;
    private final CandidateBuffer candidates = new CandidateBuffer();
    private double ofCircle;
    private double ofBody;
    private long version = -1;

    FreeTravel(ObstacleSet obstacles) {
        this.obstacles = obstacles;
    }

    /** Forgets the bounds, after the body has changed. */
    void invalidate() {
        version = -1;
    }

    /**
     * Subtracts a motion from the free travel if it is certain to touch nothing.
     *
     * @param body the body before the motion
     * @param time seconds, at the body's current wheel speeds
     * @return false if the motion must be tested for contact
     */
    boolean take(RobotBody body, double time) {
        double translation = Math.abs(body.v()) * time;
        double rotation = Math.abs(body.omega()) * time * body.boundingRadius();
        if (version != obstacles.version() || !suffices(translation, rotation)) {
            measure(body, translation);
        }
        boolean free = suffices(translation, rotation);
        ofCircle -= translation;
        ofBody -= translation + rotation;
        return free;
    }

    private boolean suffices(double translation, double rotation) {
        return translation < ofCircle || translation + rotation < ofBody;
    }

    private void measure(RobotBody body, double translation) {
        version = obstacles.version();
        double radius = body.boundingRadius();
        double look = LOOK_AHEAD + translation;
        candidates.clear();
        obstacles.findStaticNear(body.x(), body.y(), radius + look, candidates);
        double nearest = radius + look;
        for (int i = 0; i < candidates.size(); i++) {
            nearest = Math.min(nearest, candidates.shape(i).distanceTo(body.x(), body.y()));
        }
        ofCircle = nearest - radius - MARGIN;
        ofBody = ofCircle;
        if (ofCircle <= translation) {
            ofBody = look - MARGIN;
            OrientedBox box = body.box();
            for (int i = 0; i < candidates.size(); i++) {
                ofBody = Math.min(
                        ofBody, BoxDistance.between(box, candidates.shape(i)).distance() - MARGIN);
            }
        }
    }
}
