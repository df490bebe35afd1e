package faultline.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** Fetches what a scenario file holds, or says in one sentence why it cannot. */
final class ScenarioBytes {

    private ScenarioBytes() {
    }

    static byte[] ofFile(Path file) throws ScenarioException {
        String name = file.toString();
        try {
            checkKind(name, file);
            return notEmpty(name, Files.readAllBytes(file));
        } catch (NoSuchFileException e) {
            throw complaint(name, "there is no such file");
        } catch (IOException e) {
            throw complaint(name, "the file cannot be read");
        }
    }

    /** Before anything is read: a device or a pipe could go on for ever. */
    private static void checkKind(String name, Path file) throws ScenarioException, IOException {
        if (Files.isDirectory(file)) {
            throw complaint(name, "this is a folder, allowed is a scenario file");
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw complaint(name, "this is no regular file, allowed is a scenario file");
        }
        if (Files.size(file) > Limits.MOST_BYTES) {
            throw complaint(name, "the file has " + Files.size(file) + " bytes, allowed is " + Limits.MOST_BYTES);
        }
    }

    static byte[] shipped(String name) throws ScenarioException {
        try (InputStream in = ScenarioBytes.class.getResourceAsStream("/scenarios/" + name)) {
            if (in == null) {
                throw complaint(name, "no such scenario ships with the program");
            }
            return notEmpty(name, in.readAllBytes());
        } catch (IOException e) {
            throw complaint(name, "the scenario cannot be read from the program's own files");
        }
    }

    private static byte[] notEmpty(String name, byte[] bytes) throws ScenarioException {
        if (bytes.length == 0) {
            throw complaint(name, "the file is empty, allowed is a scenario");
        }
        return bytes;
    }

    private static ScenarioException complaint(String name, String text) {
        return new ScenarioException(List.of(new Complaint(name, Place.NONE, text)));
    }
}
