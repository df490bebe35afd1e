package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A built-in controller as the child of a simulator that violates the protocol. */
class BuiltInChildTest {

    /** The other simulator's greeting is ours with a replaced part; its observation follows. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
            hello           | observe         |                                | wrote an observe message before the hello message
            "protocol":1    | "protocol":2    |                                | speaks protocol 2; expected 1
            "dt_s":0.01     | "dt_s":-0       |                                | has ticks of -0 s; expected more than 0
            "robot":        | "robt":         |                                | wrote a message whose "robot" is missing; expected an object
            "width_m":0.2   | "width_m":-0.2  |                                | describes a robot that cannot be: the robot's width must be positive: -0.2
            "front-left"    | "front"         |                                | describes a robot that cannot be: two sensors have the id front
            "protocol":1    | "protocol":1.0  | "readings_m":[],"answers":[]   | wrote an observe message with 0 readings and 0 answers; expected 8 of each, one for each sensor
            "protocol":1    | "protocol":1.0  | "readings_m":[1e999],"answers":[true] | wrote a message whose "readings_m" is "[1e999]"; expected an array of finite numbers
            """)
    void aBadMessageEndsTheControllerInOneSentence(String part, String other, String readings, String sentence)
            throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/office.xml")).setup();
        String hello = ProtocolMessages.hello(RunDescription.of("test", "Office", setup, 1));
        String observe = "{\"type\":\"observe\",\"tick\":0," + readings + "}";
        byte[] in = (hello.replace(part, other) + "\n" + observe + "\n").getBytes(StandardCharsets.UTF_8);
        BuiltInChild child = new BuiltInChild(new ByteArrayInputStream(in), new ByteArrayOutputStream());
        RunFailedException e = assertThrows(RunFailedException.class, () -> child.run(setup.controller()));
        assertEquals("the simulator " + sentence, e.getMessage());
    }
}
