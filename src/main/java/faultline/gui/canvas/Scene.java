package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.world.Obstacle;
import java.util.List;
import java.util.Optional;

/** The frame that shows, and which of its obstacles is selected. */
final class Scene {

    private final Watched<Optional<String>> selection = new Watched<>(Optional.empty());
    private Optional<Frame> frame = Optional.empty();

    /** Takes a newer frame; an obstacle that it lacks is no longer selected. */
    void show(Frame newest) {
        frame = Optional.of(newest);
        if (selected().isEmpty()) {
            selection.set(Optional.empty());
        }
    }

    Optional<Frame> frame() {
        return frame;
    }

    Watched<Optional<String>> selection() {
        return selection;
    }

    List<Obstacle> obstacles() {
        return frame.map(f -> f.world().obstacles()).orElse(List.of());
    }

    Optional<Obstacle> obstacle(String id) {
        return obstacles().stream().filter(obstacle -> obstacle.id().equals(id)).findFirst();
    }

    Optional<Obstacle> selected() {
        return selection.get().flatMap(this::obstacle);
    }
}
