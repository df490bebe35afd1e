package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A robot among the legs of furniture, as in the floor plans of buildings: eighty boxes of 3 to 15 cm in a room of 6 m
 * x 5 m. Their gaps are narrower than the turning circle in places, so a contact cannot always be avoided.
 */
class ClutterTest {

    private static final int LEGS = 80;
    private static final double SPACING = 0.42;
    private static final double CLEARING = 0.6;
    private static final Vector2 START = new Vector2(3, 2.5);
    private static final int ROOMS = 60;
    private static final long FIRST_ROOM = 9000;

    private static SimulationSetup room(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Obstacle> legs = new ArrayList<>();
        for (int tries = 0; tries < 5000 && legs.size() < LEGS; tries++) {
            Pose pose = new Pose(random.nextDouble(0.3, 5.7), random.nextDouble(0.3, 4.7), random.nextDouble(Math.PI));
            double side = random.nextDouble(0.03, 0.15);
            boolean free = pose.position().distanceTo(START) > CLEARING
                    && legs.stream().allMatch(leg -> leg.pose().position().distanceTo(pose.position()) > SPACING);
            if (free) {
                legs.add(new Obstacle("leg" + legs.size(), new ObstacleShape.RectangleShape(side, side), pose));
            }
        }
        return SimulationSetup.of(
                        new WorldSpec(6, 5, true, 0, legs),
                        new Pose(START.x(), START.y(), random.nextDouble(2 * Math.PI)))
                .withDuration(300);
    }

    private static boolean touchesSomething(long seed, boolean diagnosis) {
        SimulationSetup setup =
                room(seed).withController(ControllerSpec.WallFollowing.DEFAULT.withDiagnosis(diagnosis));
        return HeadlessRun.run(setup, ControllerMode.DIRECT, List.of())
                .collision()
                .isPresent();
    }

    /** At commit 673d2fe8~1, without the memory of blind spots, 25 touch something with diagnosis and 26 without. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void mostRobotsTouchNothingIn300Seconds(boolean diagnosis) {
        long contacts = LongStream.range(FIRST_ROOM, FIRST_ROOM + ROOMS)
                .filter(seed -> touchesSomething(seed, diagnosis))
                .count();
        assertTrue(contacts <= 8, contacts + " contacts");
    }
}
