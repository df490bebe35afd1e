package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What stays selected, and what becomes so, while obstacles come and go. */
class SceneTest {

    private final Scene scene = new Scene();

    private static Frame with(String... ids) {
        return SampleFrames.of(new Pose(1, 1, 0),
                Stream.of(ids).map(id -> new Obstacle(id, new ObstacleShape.Circle(0.1), new Pose(4, 3, 0))).toArray(Obstacle[]::new));
    }

    private Set<String> selected() {
        return scene.selection().get();
    }

    @Test
    void whatIsGoneIsSelectedNoMore() {
        scene.show(with("desk", "lamp", "pole"));
        scene.select(List.of("lamp", "desk"));
        scene.show(with("pole", "lamp"));
        assertEquals(Set.of("lamp"), selected());
    }

    @Test
    void whatIsAwaitedIsSelectedOnceItIsAllThere() {
        scene.show(with("desk"));
        scene.select(List.of("desk"));
        scene.await(List.of("lamp", "pole"));
        scene.show(with("desk", "lamp"));
        assertEquals(Set.of("desk"), selected());
        scene.show(with("desk", "lamp", "pole"));
        assertEquals(Set.of("lamp", "pole"), selected());
    }

    @Test
    void whatIsAwaitedIsStillAwaitedWhereSomethingSelectedIsGone() {
        scene.show(with("desk"));
        scene.select(List.of("desk"));
        scene.await(List.of("lamp"));
        scene.show(with("pole"));
        assertEquals(Set.of(), selected());
        scene.show(with("lamp"));
        assertEquals(Set.of("lamp"), selected());
    }

    @Test
    void aFrameWithTheSameObstaclesChangesNothing() {
        List<Set<String>> told = new ArrayList<>();
        scene.show(with("desk", "lamp"));
        scene.select(List.of("desk"));
        scene.selection().listen(told::add);
        scene.show(with("lamp", "desk"));
        assertEquals(List.of(), told);
    }
}
