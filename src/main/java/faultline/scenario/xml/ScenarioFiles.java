package faultline.scenario.xml;

import faultline.io.AtomicFile;
import faultline.io.ByteCount;
import faultline.io.Message;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;

/** Reads and writes scenario files. */
public final class ScenarioFiles {

    private ScenarioFiles() {}

    /**
     * {@return the content of a scenario file}
     *
     * @param file the file
     * @throws ScenarioException with everything that is wrong with the file
     */
    public static ScenarioContent read(Path file) throws ScenarioException {
        return parse(file.toString(), readBytes(file));
    }

    static byte[] readBytes(Path file) throws ScenarioException {
        return readBytes(file, Allowed.SCENARIO_FILE.with());
    }

    /**
     * {@return the bytes of a file}
     *
     * @param file the file
     * @param kind what the file is to be, such as {@link Allowed#SCENARIO_FILE}, for problems
     * @throws ScenarioException if the file cannot be read, or is too large
     */
    public static byte[] readBytes(Path file, Object kind) throws ScenarioException {
        String name = file.toString();
        try {
            checkRegularFile(name, file, kind);
            return Files.readAllBytes(file);
        } catch (NoSuchFileException e) {
            throw problem(name, ProblemKind.NO_SUCH_FILE.with());
        } catch (IOException e) {
            throw problem(name, ProblemKind.UNREADABLE_FILE.with());
        }
    }

    /** Checked before anything is read: a device or a pipe could continue without end. */
    private static void checkRegularFile(String name, Path file, Object kind) throws ScenarioException, IOException {
        if (Files.isDirectory(file)) {
            throw problem(name, ProblemKind.FOLDER.with(kind));
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw problem(name, ProblemKind.IRREGULAR_FILE.with(kind));
        }
        if (Files.size(file) > ScenarioLimits.MAX_BYTES) {
            throw problem(
                    name,
                    ProblemKind.TOO_MANY_BYTES.with(
                            ByteCount.format(Files.size(file)), ByteCount.format(ScenarioLimits.MAX_BYTES)));
        }
    }

    /**
     * {@return the content of a scenario that is part of the program}
     *
     * @param name the name of a file in the folder {@code scenarios}
     * @throws ScenarioException if there is none of that name
     */
    public static ScenarioContent readShipped(String name) throws ScenarioException {
        try (InputStream in = ScenarioFiles.class.getResourceAsStream("/scenarios/" + name)) {
            if (in == null) {
                throw problem(name, ProblemKind.NOT_SHIPPED.with());
            }
            return parse(name, in.readAllBytes());
        } catch (IOException e) {
            throw problem(name, ProblemKind.UNREADABLE_RESOURCE.with());
        }
    }

    /**
     * {@return the content of a scenario file with some bytes}
     *
     * @param name the name of the file in problems
     * @param bytes the content
     * @throws ScenarioException with everything that is wrong with it
     */
    public static ScenarioContent parse(String name, byte[] bytes) throws ScenarioException {
        if (bytes.length == 0) {
            throw new ScenarioException(
                    List.of(new Problem(name, new SourceLocation(1, 1), ProblemKind.EMPTY_FILE.with())));
        }
        return ScenarioReader.read(name, bytes);
    }

    /**
     * Writes a scenario file, completely or not at all.
     *
     * @param content the content, which is checked to read back the same
     * @param file the file; an existing one is replaced
     * @param comments the comments that a person has put into the file
     * @throws IOException if the file cannot be written, or the content is beyond the limits of the format
     */
    public static void write(ScenarioContent content, Path file, XmlComments comments) throws IOException {
        byte[] bytes = ScenarioWriter.toBytes(content, comments);
        AtomicFile.write(file, bytes);
    }

    /**
     * {@return the bytes of a scenario file, which are checked to read back the same}
     *
     * @param content the content
     * @throws IOException if the content is beyond the limits of the format
     */
    public static byte[] toBytes(ScenarioContent content) throws IOException {
        return ScenarioWriter.toBytes(content, XmlComments.NONE);
    }

    private static ScenarioException problem(String name, Message message) {
        return new ScenarioException(List.of(new Problem(name, SourceLocation.NONE, message)));
    }
}
