package faultline.scenario.xml;

import faultline.io.ByteCount;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

/** Reads the bytes of a file, or reports why it cannot be read. */
public final class XmlFile {

    private XmlFile() {}

    /** Ends a pass at the root element. */
    private static final class RootReader extends DefaultHandler {

        /** Null until the root element is read. */
        private String namespace;

        private final Map<String, String> attributes = new HashMap<>();

        /** Creates a reader that has read as much of a file as it can. */
        static RootReader of(Path file) {
            RootReader root = new RootReader();
            try {
                if (Files.isRegularFile(file) && Files.size(file) <= ScenarioLimits.MAX_BYTES) {
                    try (InputStream in = Files.newInputStream(file)) {
                        XmlParser.newParser().parse(in, root);
                    }
                }
            } catch (SAXException | IOException e) {
                // The root element has been read, or the file is reported when all of it is read.
            }
            return root;
        }

        @Override
        public void startElement(String uri, String localName, String qName, Attributes given) throws SAXException {
            namespace = uri;
            for (int i = 0; i < given.getLength(); i++) {
                attributes.put(given.getQName(i), given.getValue(i));
            }
            throw new SAXException("the rest of the file is not needed");
        }
    }

    /**
     * {@return the namespace of the root element of a file, an empty text if it has none; empty if the file cannot be
     * read up to there}
     *
     * @param file the file
     */
    public static Optional<String> rootNamespace(Path file) {
        return Optional.ofNullable(RootReader.of(file).namespace);
    }

    /**
     * {@return whether a file is a scenario that is the record of a run, as far as its root element says}
     *
     * @param file the file
     */
    public static boolean isRecordedScenario(Path file) {
        RootReader root = RootReader.of(file);
        return XmlFormat.SCENARIO.namespace().equals(root.namespace) && "true".equals(root.attributes.get("recorded"));
    }

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
        checkSize(name, Files.size(file));
    }

    /**
     * Checks the size of a file.
     *
     * @param name the name of the file
     * @param bytes the number of its bytes
     * @throws ScenarioException if it has more than {@link ScenarioLimits#MAX_BYTES}
     */
    public static void checkSize(String name, long bytes) throws ScenarioException {
        if (bytes > ScenarioLimits.MAX_BYTES) {
            throw new ScenarioException(
                    name,
                    ProblemKind.TOO_MANY_BYTES.with(
                            ByteCount.format(bytes), ByteCount.format(ScenarioLimits.MAX_BYTES)));
        }
    }
}
