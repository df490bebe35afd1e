package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Paths of a body that is 0.2 m wide, beside those at 0.35 m from the walls. */
class BodyPathsTest {

    private static final double DISTANCE = 0.35;
    private static final double WIDTH = 0.2;
    private static final Vector2 LEFT = new Vector2(1, DISTANCE);
    private static final Vector2 RIGHT = new Vector2(5, DISTANCE);

    private static WallCircuit circuit(WorldSpec world) {
        List<WallReference.WallSample> places = new WallReference(world).samplesAlongPath(DISTANCE, 0.02);
        return new WallCircuit(places, 0.02, 0.04, 0.15, circuit -> BodyPaths.of(circuit, DISTANCE, world, WIDTH));
    }

    private static WallCircuit twoBoxes(double gap) {
        return circuit(new WorldSpec(6, 4, false, 3, List.of(box("low", 1, 0.2), box("high", 1.2 + gap, 0.2))));
    }

    /** Two rooms with a door in the wall between them. */
    private static WallCircuit twoRooms(double door) {
        double height = (3 - door) / 2;
        ObstacleShape wall = new ObstacleShape.RectangleShape(0.2, height);
        return circuit(new WorldSpec(
                6,
                3,
                true,
                3,
                List.of(
                        new Obstacle("low", wall, new Pose(3, height / 2, 0)),
                        new Obstacle("high", wall, new Pose(3, 3 - height / 2, 0)))));
    }

    private static boolean isPassed(WallCircuit rooms) {
        BodyPaths body = rooms.bodyPaths();
        return body.path(rooms.nearestPlace(LEFT)) == body.path(rooms.nearestPlace(RIGHT));
    }

    private static Obstacle box(String id, double y, double height) {
        return new Obstacle(id, new ObstacleShape.RectangleShape(1, height), new Pose(3, y, 0));
    }

    private static boolean isDivided(WallCircuit circuit) {
        return circuit.bodyPaths().path(circuit.size() - 1)
                != circuit.bodyPaths().path(0);
    }

    @Test
    void aPathOfTheBodyLeadsAroundEachOfTwoBoxes() {
        WallCircuit circuit = twoBoxes(0.5);
        BodyPaths body = circuit.bodyPaths();
        int high = IntStream.range(0, circuit.size())
                .filter(i -> circuit.place(i).position().y() > 1.35)
                .findFirst()
                .orElseThrow();
        for (int i = 0; i < circuit.size(); i++) {
            assertEquals(0, circuit.path(i));
            assertEquals(circuit.place(i).position().y() > 1.35 ? high : 0, body.path(i), "place " + i);
        }
        assertEquals(circuit.length(0), body.length(0) + body.length(high), 1e-9);
        assertEquals(Math.max(body.length(0), body.length(high)), body.maxLength());
    }

    /** The limits that docs/campaigns.md states: 0.04 m more than the platform's width and than twice the distance. */
    @Test
    void anIslandIsBehindAPassageWithinTheLimits() {
        assertTrue(!isDivided(twoBoxes(0.238)));
        assertTrue(isDivided(twoBoxes(0.242)));
        WallCircuit narrow = twoBoxes(0.738);
        assertEquals(narrow.path(0), narrow.path(narrow.size() - 1));
        assertTrue(isDivided(narrow));
        WallCircuit wide = twoBoxes(0.742);
        assertNotEquals(wide.path(0), wide.path(wide.size() - 1));
    }

    @Test
    void aDoorIsPassedIfItIsWiderThanThePlatform() {
        assertTrue(!isPassed(twoRooms(0.198)));
        assertTrue(isPassed(twoRooms(0.202)));
        WallCircuit circuit = twoRooms(0.5);
        assertTrue(isPassed(circuit));
        assertNotEquals(circuit.path(circuit.nearestPlace(LEFT)), circuit.path(circuit.nearestPlace(RIGHT)));
    }

    @Test
    void withoutNarrowPassagesThePathsOfTheBodyAreThoseOfTheCircuit() throws ScenarioException {
        for (String name : List.of("yard.xml", "outer-corners.xml")) {
            WallCircuit circuit = circuit(Scenario.loadShipped(name).setup().world());
            for (int i = 0; i < circuit.size(); i++) {
                assertEquals(circuit.path(i), circuit.bodyPaths().path(i), name + ", place " + i);
                assertEquals(circuit.length(i), circuit.bodyPaths().length(i));
            }
        }
    }

    /** A search for the nearest of all places near each other one took more than 20 s. */
    @Test
    void manyBoxesInOnePlaceTakeLittleTime() {
        WallCircuit circuit = circuit(new WorldSpec(
                10,
                10,
                true,
                3,
                IntStream.range(0, 450).mapToObj(i -> box("box" + i, 5, 1)).toList()));
        CpuTime time = CpuTime.start();
        assertEquals(circuit.path(circuit.size() - 1), circuit.bodyPaths().path(circuit.size() - 1));
        time.assertBelow(3);
    }

    /** Half its width is more than the distance. */
    @Test
    void aPlatformThatFillsEveryPassageHasThePathsOfTheCircuit() {
        WallCircuit circuit = twoBoxes(0.5);
        BodyPaths body = BodyPaths.of(circuit, DISTANCE, new WorldSpec(6, 4, false, 3, List.of()), 0.8);
        assertEquals(0, body.path(circuit.size() - 1));
        assertEquals(circuit.maxLength(), body.maxLength());
    }
}
