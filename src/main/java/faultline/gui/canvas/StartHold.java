package faultline.gui.canvas;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.edit.ShapeHandles;
import faultline.gui.edit.Snap;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The robot in the hand before a run has begun: where it is let go, the run starts. */
final class StartHold implements Hold {

    private final Snapshot world;
    private final boolean turns;
    private final Vec pressed;
    private final Viewpoint viewpoint;
    private final Watchers watchers;
    private Optional<Pose> wanted = Optional.empty();
    private Vec last;

    StartHold(Snapshot world, boolean turns, Vec pressed, Viewpoint viewpoint, Watchers watchers) {
        this.world = world;
        this.turns = turns;
        this.pressed = pressed;
        this.viewpoint = viewpoint;
        this.watchers = watchers;
        this.last = pressed;
    }

    @Override
    public void to(Vec screen, Snap snap) {
        last = screen;
        if (wanted.isPresent() || screen.distanceTo(pressed) >= CLICK) {
            Vec mouse = viewpoint.camera().get().toWorld(screen);
            wanted = Optional.of(turns ? turned(mouse, snap) : moved(mouse, snap));
        }
    }

    private Pose moved(Vec mouse, Snap snap) {
        Vec grip = viewpoint.camera().get().toWorld(pressed);
        Vec place = snap.place(world.pose().position().plus(mouse.minus(grip)));
        return new Pose(place.x(), place.y(), world.pose().heading());
    }

    private Pose turned(Vec mouse, Snap snap) {
        double heading = snap.angle(mouse.minus(world.pose().position()).angle());
        return new Pose(world.pose().x(), world.pose().y(), heading);
    }

    @Override
    public void release() {
        wanted.ifPresent(pose -> Room.obstructing(world, pose).ifPresentOrElse(
                obstacle -> watchers.note(Texts.text("refused.start", obstacle)), () -> watchers.start(pose)));
    }

    @Override
    public void paint(Brush brush) {
        wanted.ifPresent(pose -> {
            Optional<String> obstructing = Room.obstructing(world, pose);
            HandPainter.paintRobot(brush, world.robot(), pose, obstructing.isPresent());
            obstructing.ifPresentOrElse(id -> HandPainter.paintRefusal(brush, Texts.text("refused.start", id), List.of(), last),
                    () -> HandPainter.paintValues(brush, values(pose), List.of(), last));
        });
    }

    private String values(Pose pose) {
        String degrees = String.format(Locale.ROOT, "%.1f", Math.toDegrees(Math.IEEEremainder(pose.heading(), 2 * Math.PI)));
        return turns ? Texts.text("value.heading", degrees) : Texts.text("value.place", ShapeHandles.metres(pose.x()), ShapeHandles.metres(pose.y()));
    }
}
