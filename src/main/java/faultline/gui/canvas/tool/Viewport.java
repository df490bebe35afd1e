package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Camera;
import faultline.world.Snapshot;
import java.util.function.UnaryOperator;

/**
 * The view of the canvas. It fits the whole world into the canvas, also when the canvas is resized, until the user
 * zooms or pans. A robot that it follows begins in the centre; then the view moves only as far as necessary to keep the
 * robot in the middle part, because every move repaints the ground.
 */
public final class Viewport {

    /** The largest offset of a followed robot from the centre, as a fraction of the size of the canvas. */
    private static final double MAX_OFFSET = 0.2;

    private final ObservableValue<Camera> camera = new ObservableValue<>(new Camera(0, 0, 100, 1, 1));
    private Snapshot world;
    private boolean fitting = true;
    private boolean following;

    public ObservableValue<Camera> camera() {
        return camera;
    }

    /** Prepares for another scenario, whose first world is fitted. */
    void startScenario() {
        world = null;
    }

    /** Sets the newest world; the first one of a scenario, and one of another size than the last, is fitted. */
    public void setWorld(Snapshot newest) {
        boolean known = world != null && world.width() == newest.width() && world.height() == newest.height();
        world = newest;
        if (!known) {
            fit();
        }
        followRobot();
    }

    /** Sets the size of the canvas, pixels. A layout that keeps the size keeps the view, too. */
    public void resize(int width, int height) {
        Camera resized = camera.get().resized(Math.max(1, width), Math.max(1, height));
        if (resized.equals(camera.get())) {
            return;
        }
        camera.set(resized);
        if (fitting) {
            fit();
        }
    }

    public void fit() {
        fitting = true;
        Camera now = camera.get();
        if (world != null) {
            camera.set(FrameRenderer.fitCamera(world, now.width(), now.height()));
        }
    }

    /** Moves the camera as the user wants. */
    public void moveCamera(UnaryOperator<Camera> change) {
        fitting = false;
        camera.set(change.apply(camera.get()));
    }

    public void zoom(double factor) {
        Camera now = camera.get();
        zoomAbout(new Vector2(now.width() / 2.0, now.height() / 2.0), factor);
    }

    /** Zooms about a position, pixels; a followed robot is kept in the middle part. */
    public void zoomAbout(Vector2 screen, double factor) {
        moveCamera(c -> c.zoomedAbout(screen, factor));
        followRobot();
    }

    /** Sets whether the view follows the robot, which begins in the centre. */
    public void setFollowing(boolean follow) {
        following = follow;
        if (follow && world != null) {
            moveRobot(0);
        }
    }

    public boolean isFollowing() {
        return following;
    }

    private void followRobot() {
        if (following && world != null) {
            moveRobot(MAX_OFFSET);
        }
    }

    /** Moves the view so that the robot is at most so far from the centre, as a fraction of the size of the canvas. */
    private void moveRobot(double maxOffset) {
        Camera now = camera.get();
        Vector2 place = now.toScreen(world.pose().position());
        // The view moves by whole pixels, so that cached layers can be shifted.
        double dx = Math.rint(excess(place.x() - now.width() / 2.0, maxOffset * now.width()));
        double dy = Math.rint(excess(place.y() - now.height() / 2.0, maxOffset * now.height()));
        if (dx != 0 || dy != 0) {
            moveCamera(c -> c.panned(-dx, -dy));
        }
    }

    private static double excess(double offset, double allowed) {
        return offset - Math.max(-allowed, Math.min(allowed, offset));
    }
}
