package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.paint.Camera;
import faultline.paint.FrameImage;
import faultline.world.Snapshot;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Where the canvas looks. At first, and whenever it is told to, it shows the whole world and goes on doing so when the canvas is
 * resized, until a hand zooms or pans; when it follows, it moves only as far as keeps the robot in the middle part, because every
 * move costs a new picture of the ground.
 */
final class Viewpoint {

    /** How far from the middle the robot may go before the view moves, as a share of the canvas's size. */
    private static final double SLACK = 0.2;

    private final Watched<Camera> camera = new Watched<>(new Camera(0, 0, 100, 1, 1));
    private Optional<Snapshot> world = Optional.empty();
    private boolean fitted = true;
    private boolean following;

    Watched<Camera> camera() {
        return camera;
    }

    /** Takes the newest world; one of another size than the last is fitted. */
    void show(Snapshot newest) {
        boolean known = world.filter(old -> old.width() == newest.width() && old.height() == newest.height()).isPresent();
        world = Optional.of(newest);
        if (!known) {
            fit();
        }
        follow();
    }

    void resize(int width, int height) {
        camera.set(camera.get().resized(Math.max(1, width), Math.max(1, height)));
        if (fitted) {
            fit();
        }
    }

    void fit() {
        fitted = true;
        Camera now = camera.get();
        world.ifPresent(w -> camera.set(FrameImage.camera(w, now.width(), now.height())));
    }

    /** Moves the camera as a hand wants it. */
    void move(UnaryOperator<Camera> hand) {
        fitted = false;
        camera.set(hand.apply(camera.get()));
    }

    void zoom(double factor) {
        move(c -> c.zoomedAbout(new Vec(c.width() / 2.0, c.height() / 2.0), factor));
    }

    void setFollowing(boolean follow) {
        following = follow;
        follow();
    }

    boolean isFollowing() {
        return following;
    }

    private void follow() {
        if (following) {
            world.ifPresent(w -> keepInMiddle(w.pose().position()));
        }
    }

    private void keepInMiddle(Vec robot) {
        Camera now = camera.get();
        Vec place = now.toScreen(robot);
        // By whole pixels, so that what is kept of the picture can be moved.
        double dx = Math.rint(excess(place.x() - now.width() / 2.0, SLACK * now.width()));
        double dy = Math.rint(excess(place.y() - now.height() / 2.0, SLACK * now.height()));
        if (dx != 0 || dy != 0) {
            move(c -> c.panned(-dx, -dy));
        }
    }

    private static double excess(double offset, double allowed) {
        return offset - Math.max(-allowed, Math.min(allowed, offset));
    }
}
