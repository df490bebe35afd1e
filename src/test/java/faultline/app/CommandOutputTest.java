package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class CommandOutputTest {

    /** A locale without an encoding, as in many containers, has an output in ASCII. */
    @Test
    void jsonKeepsLettersThatTheOutputCannotEncode() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        CommandOutput output = new CommandOutput(new PrintStream(bytes, true, StandardCharsets.US_ASCII), System.err);
        output.println("wänd");
        output.printJson("\"wänd\"");
        output.println("end");
        assertEquals(String.format("w?nd%n\"wänd\"%nend%n"), bytes.toString(StandardCharsets.UTF_8));
    }
}
