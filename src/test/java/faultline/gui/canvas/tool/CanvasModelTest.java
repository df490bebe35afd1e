package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The selection while obstacles are added and removed. */
class CanvasModelTest {

    private final CanvasModel model = new CanvasModel();

    private static Frame with(String... ids) {
        return SampleFrames.frameOf(
                new Pose(1, 1, 0),
                Stream.of(ids)
                        .map(id -> new Obstacle(id, new ObstacleShape.CircleShape(0.1), new Pose(4, 3, 0)))
                        .toArray(Obstacle[]::new));
    }

    private Set<String> selected() {
        return model.selection().get();
    }

    @Test
    void aRemovedObstacleIsNoLongerSelected() {
        model.setFrame(with("desk", "lamp", "pole"));
        model.select(List.of("lamp", "desk"));
        model.setFrame(with("pole", "lamp"));
        assertEquals(Set.of("lamp"), selected());
    }

    @Test
    void obstaclesAreSelectedInsteadOfASensor() {
        model.setFrame(with("desk"));
        model.sensor().set(Optional.of("left"));
        model.select(List.of());
        assertEquals(Optional.of("left"), model.sensor().get());
        model.select(List.of("desk"));
        assertEquals(Optional.empty(), model.sensor().get());
    }

    @Test
    void aNewSensorIsSelectedOnceAFrameHasIt() {
        model.selectSensorWhenPresent("left");
        assertEquals(Optional.empty(), model.sensor().get());
        model.setFrame(SampleFrames.fullFrame());
        assertEquals(Optional.of("left"), model.sensor().get());
        model.sensor().set(Optional.of("right"));
        model.setFrame(SampleFrames.fullFrame());
        assertEquals(Optional.of("right"), model.sensor().get(), "only once");
    }

    private static Frame withSensors(String... ids) {
        Pose robot = new Pose(1, 1, 0);
        List<SensorSnapshot> sensors = Stream.of(ids)
                .map(id -> RobotSpec.DEFAULT.sensors().get(0).withId(id))
                .map(spec -> SampleFrames.sensor(spec, robot, SampleFrames.NOTHING))
                .toList();
        return SampleFrames.frameOf(robot, SampleFrames.pathThrough(robot.position()), sensors);
    }

    @Test
    void aSensorStaysSelectedWhenItGetsAnotherId() {
        model.setFrame(withSensors("front", "left"));
        model.sensor().set(Optional.of("left"));
        model.selectSensorWhenPresent("sensor-3");
        model.renameSensors(id ->
                Map.of("front", "bow", "left", "port", "sensor-3", "stern").get(id));
        model.setFrame(withSensors("bow", "port"));
        assertEquals(Optional.of("port"), model.sensor().get());
        model.setFrame(withSensors("bow", "port", "stern"));
        assertEquals(Optional.of("stern"), model.sensor().get(), "awaited");
        model.sensor().set(Optional.of("port"));
        model.setFrame(withSensors("front", "rear"));
        assertEquals(Optional.empty(), model.sensor().get(), "removed");
    }

    @Test
    void aPendingSelectionIsAppliedOnceItsObstaclesArePresent() {
        model.setFrame(with("desk"));
        model.select(List.of("desk"));
        model.selectWhenPresent(List.of("lamp", "pole"));
        model.setFrame(with("desk"));
        assertEquals(Set.of("desk"), selected());
        model.setFrame(with("desk", "lamp", "pole"));
        assertEquals(Set.of("lamp", "pole"), selected());
    }

    /** The world may refuse some, such as the fourth obstacle that moves. */
    @Test
    void thoseThatAreNotAddedAreNotAwaited() {
        model.setFrame(with("desk"));
        model.select(List.of("desk"));
        model.selectWhenPresent(List.of("lamp", "pole"));
        model.setFrame(with("desk", "lamp"));
        assertEquals(Set.of("lamp"), selected());
        model.setFrame(with("desk", "lamp", "pole"));
        assertEquals(Set.of("lamp"), selected());
    }

    @Test
    void aPendingSelectionSurvivesTheRemovalOfASelectedObstacle() {
        model.setFrame(with("desk"));
        model.select(List.of("desk"));
        model.selectWhenPresent(List.of("lamp"));
        model.setFrame(with("pole"));
        assertEquals(Set.of(), selected());
        model.setFrame(with("lamp"));
        assertEquals(Set.of("lamp"), selected());
    }

    @Test
    void aFrameWithTheSameObstaclesChangesNothing() {
        List<Set<String>> selections = new ArrayList<>();
        model.setFrame(with("desk", "lamp"));
        model.select(List.of("desk"));
        model.selection().addListener(selections::add);
        model.setFrame(with("lamp", "desk"));
        assertEquals(List.of(), selections);
    }
}
