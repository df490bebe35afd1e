package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.metrics.WallFollowingRun.Conditions;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Rooms that a follower has failed in, each with what it got wrong. */
class HardRoomsTest {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;

    private static void assertFollowed(PolygonRoom room) {
        assertEquals(
                List.of(), WallFollowingRun.simulate(room, Conditions.DEFAULT).violations(), room::toString);
    }

    @Test
    void theNoiseOfASharpTipIsForgottenAlongTheWallBehindIt() {
        assertFollowed(new PolygonRoom(
                "a tip of 20 degrees, after which the wall was taken for a circle for ever",
                List.of(
                        new Vector2(5.340961479213444, 3.8410933425001783),
                                new Vector2(4.527542712139212, 4.391170713486956),
                        new Vector2(4.929428905779633, 6.534492955773434),
                                new Vector2(5.491560334238442, 5.4508379940946465)),
                new Pose(5.360883707450315, 8.983687104893772, -1.7609522807926352)));
    }

    @Test
    void aTipThatHasSlippedOutOfTheFrontConeIsNotRunInto() {
        assertFollowed(new PolygonRoom(
                "a wedge met tip first, while the front sensor saw its flank farther on",
                List.of(
                        new Vector2(4.791928440310932, 4.039230709632927),
                        new Vector2(3.5421238188201736, 5.084683644795077),
                        new Vector2(6.117839495546213, 5.626455656734558)),
                new Pose(8.65633492034342, 6.6221020159895225, -2.798347125569634)));
    }

    @Test
    void anObstacleFartherOffIsNotTakenForTheWallThatWasMet() {
        assertFollowed(new PolygonRoom(
                "an alcove's corner met on the right, while another one was in sight on the left",
                List.of(
                        new Vector2(2.5, 3),
                        new Vector2(4.753247426978839, 3),
                        new Vector2(4.753247426978839, 2.399349026972408),
                        new Vector2(6.0593914203299635, 2.399349026972408),
                        new Vector2(6.0593914203299635, 3),
                        new Vector2(7.5, 3),
                        new Vector2(7.5, 4.045928299591763),
                        new Vector2(6.758685178445701, 4.045928299591763),
                        new Vector2(6.758685178445701, 5.619732645919262),
                        new Vector2(7.5, 5.619732645919262),
                        new Vector2(7.5, 7),
                        new Vector2(6.195431392070615, 7),
                        new Vector2(6.195431392070615, 7.629318262327242),
                        new Vector2(3.425225946760067, 7.629318262327242),
                        new Vector2(3.425225946760067, 7),
                        new Vector2(2.5, 7),
                        new Vector2(2.5, 6.015831646516501),
                        new Vector2(1.775648359259078, 6.015831646516501),
                        new Vector2(1.775648359259078, 4.839435663561796),
                        new Vector2(2.5, 4.839435663561796)),
                new Pose(3.46827471793019, 6.0415720278356835, 5.573780412896247)));
    }

    @Test
    void rollingOutTowardsTheWallThatIsFollowedIsNotComingToTheNext() {
        assertFollowed(new PolygonRoom(
                "a thin partition, beside which the wall that was left was timed again and the one ahead run up to",
                List.of(
                        new Vector2(5.1049854483166985, 6.938009033213697),
                                new Vector2(3.852915839320196, 5.461030877218825),
                        new Vector2(4.245197000191625, 4.267249632028694),
                                new Vector2(4.700936491013666, 4.772039680960108),
                        new Vector2(4.700943913502073, 4.772032979716504),
                                new Vector2(4.245204422680032, 4.267242930785089),
                        new Vector2(4.911304091291182, 2.2401674472091417), new Vector2(7.001921359408847, 5)),
                new Pose(5.023557780930864, 5.803515136853821, 0.7639243971867833)));
    }

    /** A wall whose corner juts out between the front and the front left cone when it is met. */
    private static final PolygonRoom CORNER_BETWEEN_CONES = new PolygonRoom(
            "a wedge met tip first, a little to the left",
            List.of(
                    new Vector2(6.54900805439158, 4.745778316528551),
                    new Vector2(4.92632439172866, 3.129471266437934),
                    new Vector2(3.5526979799532388, 4.291628795949029)),
            new Pose(8.866701487780412, 6.024021290988007, -2.669742047253149));

    @Test
    void aCornerThatHasSlippedBetweenTwoConesIsMetAtTheWantedDistance() {
        List<Double> met = new ArrayList<>();
        HeadlessRun.run(
                Conditions.DEFAULT.withDuration(20).setupFor(CORNER_BETWEEN_CONES),
                ControllerMode.DIRECT,
                List.of(simulation -> {
                    if (simulation.telemetry().state() == FollowerState.FOLLOW) {
                        met.add(CORNER_BETWEEN_CONES.distance(simulation.pose().position()));
                    }
                }));
        assertEquals(0.35, met.get(0), 0.01);
    }

    /** Inner corners of 149, 136 and 140 degrees, between whose walls the reading rises by no more than 4 to 12 mm. */
    private static final PolygonRoom OBTUSE = new PolygonRoom(
            "obtuse corners",
            List.of(
                    new Vector2(5.090595516073189, 6.432903118197997),
                    new Vector2(2.1635317999275046, 6.197354773282942),
                    new Vector2(4.060589223525082, 3.9437863786525034),
                    new Vector2(6.091208760867594, 3.7198442744531666),
                    new Vector2(7.984884410800532, 5.000000000000002)),
            new Pose(5.345159736063929, 5.7263071359379, 2.951950936164629));

    @Test
    void obtuseCornersAreTimedThroughNoise() {
        RobotSpec noisy = new RobotSpec(
                ROBOT.length(),
                ROBOT.width(),
                ROBOT.track(),
                ROBOT.speed(),
                ROBOT.turnRate(),
                ROBOT.motor(),
                DriveScale.NONE,
                ROBOT.sensors().stream()
                        .map(s -> new SensorSpec(
                                s.id(), s.mountPosition(), s.bearing(), s.range(), s.cone(), s.on(), 0.002))
                        .toList());
        assertEquals(
                List.of(),
                WallFollowingRun.simulate(OBTUSE, Conditions.DEFAULT.with(noisy))
                        .violations());
    }

    @Test
    void obtuseCornersAreTimedByDecisionsThatAreFarBetween() {
        assertEquals(
                List.of(),
                WallFollowingRun.simulate(OBTUSE, Conditions.DEFAULT.with(WallFollowing.DEFAULT.withPeriod(0.05)))
                        .violations());
    }
}
