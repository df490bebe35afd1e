package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.AngleText;
import faultline.gui.text.ContactText;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.surface.DrawContext;
import faultline.world.Snapshot;
import java.util.Optional;

/** Moves or rotates the robot before the run has started; on release the run restarts there. */
public final class StartPoseGesture implements Gesture {

    private final Snapshot world;
    private final boolean rotating;
    private final Vector2 pressed;
    private final Viewport viewport;
    private final CanvasListeners listeners;
    private Pose startPose;
    private Vector2 last;

    public StartPoseGesture(
            Snapshot world, boolean rotating, Vector2 pressed, Viewport viewport, CanvasListeners listeners) {
        this.world = world;
        this.rotating = rotating;
        this.pressed = pressed;
        this.viewport = viewport;
        this.listeners = listeners;
        this.last = pressed;
    }

    @Override
    public void moveTo(Vector2 screen, SnapSettings snap) {
        last = screen;
        if (startPose != null || screen.distanceTo(pressed) >= CLICK_TOLERANCE) {
            Vector2 mouse = viewport.camera().get().toWorld(screen);
            startPose = rotating ? rotatedPose(mouse, snap) : movedPose(mouse, snap);
        }
    }

    private Pose movedPose(Vector2 mouse, SnapSettings snap) {
        Vector2 grip = viewport.camera().get().toWorld(pressed);
        Vector2 place =
                snap.point(world.pose().position(), world.pose().position().plus(mouse.minus(grip)));
        return new Pose(place.x(), place.y(), world.pose().heading());
    }

    private Pose rotatedPose(Vector2 mouse, SnapSettings snap) {
        double heading = snap.angle(mouse.minus(world.pose().position()).angle());
        return new Pose(world.pose().x(), world.pose().y(), heading);
    }

    @Override
    public void release() {
        if (startPose != null) {
            PlacementCheck.findObstruction(world, startPose)
                    .ifPresentOrElse(
                            obstacle -> listeners.fireNote(ContactText.get("refused.start", obstacle), now -> now.pose()
                                    .equals(world.pose())),
                            () -> listeners.fireStartRequested(startPose));
        }
    }

    @Override
    public void paint(DrawContext context) {
        if (startPose != null) {
            Optional<String> obstructing = PlacementCheck.findObstruction(world, startPose);
            InteractionPainter.paintRobotPreview(context, world.robot(), startPose, obstructing.isPresent());
            obstructing.ifPresentOrElse(
                    id -> InteractionPainter.paintRefusal(
                            context, ContactText.get("refused.start", id), ObstacleGroup.NONE, last),
                    () -> InteractionPainter.paintValues(context, poseText(startPose), ObstacleGroup.NONE, last));
        }
    }

    private String poseText(Pose pose) {
        return rotating
                ? Messages.get("value.heading", AngleText.degrees(pose.heading(), 1))
                : Messages.get("value.place", ShapeHandles.formatMetres(pose.x()), ShapeHandles.formatMetres(pose.y()));
    }
}
