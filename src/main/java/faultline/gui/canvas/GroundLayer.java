package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.paint.Layer;
import faultline.paint.ScenePainter;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Keeps the picture of the ground until something on it, or the view, changes. */
final class GroundLayer {

    /** All that the ground shows; where two are equal, so are their pictures. */
    private record Content(double width, double height, boolean enclosed, List<Obstacle> obstacles, Set<Layer> layers) {
    }

    private record Kept(Content content, LayerImage image) {
    }

    private Optional<Kept> kept = Optional.empty();

    /** The picture of the ground under a frame, made anew only if it must be. */
    LayerImage image(LayerImage.View view, ScenePainter painter, Frame frame, List<Obstacle> still) {
        Snapshot world = frame.world();
        Content content = new Content(world.width(), world.height(), world.enclosed(), still, painter.layers());
        if (kept.filter(old -> old.content().equals(content) && old.image().view().equals(view)).isEmpty()) {
            LayerImage image = LayerImage.opaque(view);
            image.paint(brush -> painter.paintGround(brush, world, still));
            kept = Optional.of(new Kept(content, image));
        }
        return kept.get().image();
    }
}
