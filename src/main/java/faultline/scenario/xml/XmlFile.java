package faultline.scenario.xml;

import faultline.io.ByteCount;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Reads the bytes of a file, or reports why it cannot be read. */
public final class XmlFile {

    private XmlFile() {}

    /**
     * {@return the bytes of a file}
     *
     * @param file the file
     * @param kind the expected kind of file, such as {@link Allowed#SCENARIO_FILE}, for problems
     * @throws ScenarioException if the file cannot be read, or is too large
     */
    public static byte[] readBytes(Path file, Object kind) throws ScenarioException {
        String name = file.toString();
        try {
            checkRegularFile(name, file, kind);
            return Files.readAllBytes(file);
        } catch (NoSuchFileException e) {
            throw new ScenarioException(name, ProblemKind.NO_SUCH_FILE.with());
        } catch (IOException e) {
            throw new ScenarioException(name, ProblemKind.UNREADABLE_FILE.with());
        }
    }

    /** Checked before anything is read: a device or a pipe could continue without end. */
    private static void checkRegularFile(String name, Path file, Object kind) throws ScenarioException, IOException {
        if (Files.isDirectory(file)) {
            throw new ScenarioException(name, ProblemKind.FOLDER.with(kind));
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new ScenarioException(name, ProblemKind.IRREGULAR_FILE.with(kind));
        }
        if (Files.size(file) > ScenarioLimits.MAX_BYTES) {
            throw new ScenarioException(
                    name,
                    ProblemKind.TOO_MANY_BYTES.with(
                            ByteCount.format(Files.size(file)), ByteCount.format(ScenarioLimits.MAX_BYTES)));
        }
    }
}
