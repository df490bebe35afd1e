package faultline.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** Fetches what a scenario file holds, or says in one sentence why it cannot. */
final class ScenarioSource {

    private ScenarioSource() {}

    static byte[] readFile(Path file) throws ScenarioException {
        String name = file.toString();
        try {
            checkRegularFile(name, file);
            return requireNotEmpty(name, Files.readAllBytes(file));
        } catch (NoSuchFileException e) {
            throw problem(name, "there is no such file");
        } catch (IOException e) {
            throw problem(name, "the file cannot be read");
        }
    }

    /** Before anything is read: a device or a pipe could go on for ever. */
    private static void checkRegularFile(String name, Path file) throws ScenarioException, IOException {
        if (Files.isDirectory(file)) {
            throw problem(name, "this is a folder, allowed is a scenario file");
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw problem(name, "this is no regular file, allowed is a scenario file");
        }
        if (Files.size(file) > ScenarioLimits.MAX_BYTES) {
            throw problem(name, "the file has " + Files.size(file) + " bytes, allowed is " + ScenarioLimits.MAX_BYTES);
        }
    }

    static byte[] readShipped(String name) throws ScenarioException {
        try (InputStream in = ScenarioSource.class.getResourceAsStream("/scenarios/" + name)) {
            if (in == null) {
                throw problem(name, "no such scenario ships with the program");
            }
            return requireNotEmpty(name, in.readAllBytes());
        } catch (IOException e) {
            throw problem(name, "the scenario cannot be read from the program's own files");
        }
    }

    private static byte[] requireNotEmpty(String name, byte[] bytes) throws ScenarioException {
        if (bytes.length == 0) {
            throw problem(name, "the file is empty, allowed is a scenario");
        }
        return bytes;
    }

    private static ScenarioException problem(String name, String text) {
        return new ScenarioException(List.of(new Problem(name, SourceLocation.NONE, text)));
    }
}
