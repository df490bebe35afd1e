package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SimulationSetup;
import faultline.robot.DriveScale;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenariosTest;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A client of {@code serve} and a child of {@code run --controller} that drive alike have the same run. */
@EnabledOnOs(
        value = {OS.LINUX, OS.MAC},
        disabledReason = "the child of this test is a shell script")
class ServedRunTest {

    private static final int TICKS = 50;

    private static final String VELOCITIES = "\"v_m_s\":0.2,\"omega_rad_s\":0.3";

    private static final String CHILD =
            """
            read hello; echo '{"type":"ready","protocol":1}'; i=0
            while read observation; do
              case $observation in *'"type":"end"'*) exit;; esac
              echo "{\\"type\\":\\"drive\\",\\"tick\\":$i,%s}"; i=$((i+1))
            done
            """
                    .formatted(VELOCITIES.replace("\"", "\\\""));

    /** Each shipped scenario, with its robot and with one whose drive differs from what controllers believe. */
    static Stream<Path> files() throws Exception {
        return ShippedScenariosTest.files().stream();
    }

    @ParameterizedTest
    @MethodSource("files")
    void aServedRunIsTheRunOfAChild(Path file) throws Exception {
        SimulationSetup shipped = Scenario.load(file).setup();
        SimulationSetup setup = shipped.withDuration(TICKS * shipped.dt());
        for (DriveScale scale : List.of(setup.robot().driveScale(), new DriveScale(0.95, 1.05, 1.1))) {
            SimulationSetup scaled = setup.withRobot(setup.robot().withDriveScale(scale));
            assertEquals(hashOfChild(scaled), hashOfServed(scaled), scale::toString);
        }
    }

    private static String hashOfChild(SimulationSetup setup) throws Exception {
        long hash = ExternalControllerTest.run(ExternalControllerTest.shell(CHILD), setup, 50, 50, line -> {})
                .trajectoryHash();
        return HexFormat.of().toHexDigits(hash);
    }

    private static String hashOfServed(SimulationSetup setup) throws Exception {
        String request = "{\"type\":\"drive\"," + VELOCITIES + "}\n";
        byte[] in = request.repeat(TICKS).getBytes(StandardCharsets.UTF_8);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new SimulationServer("faultline test", "Shipped", false, new ByteArrayInputStream(in), out)
                .run(setup, () -> false);
        String answers = out.toString(StandardCharsets.UTF_8);
        String key = "\"trajectory_hash\":\"";
        int hash = answers.indexOf(key) + key.length();
        return answers.substring(hash, hash + 16);
    }
}
