package faultline.campaign.plan;

import faultline.io.FileNameEncoding;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.ProblemKind;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlFile;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The files of a plan: the plan itself and the scenarios that it names.
 *
 * @param name the name of the plan, for messages
 * @param plan its bytes
 * @param scenarios the bytes of the scenarios, by their names in the plan, in its order
 */
public record PlanFiles(String name, byte[] plan, Map<String, byte[]> scenarios) {

    private static final String KIND = "campaign plan";

    /** The number of bytes within which a root element that is not well-formed must begin. */
    private static final int HEAD = 8192;

    /** The plan's name in a folder that holds a copy of all files. */
    public static final String COPY = "plan.xml";

    /**
     * Creates the files of a plan, from a copy of the map, but not of the bytes, which must not be changed.
     *
     * @param name the name of the plan, for messages
     * @param plan its bytes
     * @param scenarios the bytes of the scenarios, by their names in the plan, in its order
     */
    public PlanFiles {
        scenarios = Collections.unmodifiableMap(new LinkedHashMap<>(scenarios));
    }

    /** Gets the bytes of a scenario by its number in the plan, from 1, and its name there. */
    interface Resolver {
        byte[] read(int number, String name) throws ScenarioException;
    }

    /**
     * {@return whether a file is a plan by the namespace of its root element, or by its text if that is not
     * well-formed}
     *
     * @param file the file
     */
    public static boolean isPlan(Path file) {
        return XmlFile.rootNamespace(file)
                .map(PlanReader.FORMAT.namespace()::equals)
                .orElseGet(() -> mentionsPlans(file));
    }

    private static boolean mentionsPlans(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(file)) {
            return new String(in.readNBytes(HEAD), StandardCharsets.UTF_8).contains(PlanReader.FORMAT.namespace());
        } catch (IOException e) {
            return false;
        }
    }

    /**
     * Reads a plan, and its scenarios by their paths relative to the folder of the plan.
     *
     * @param file the file
     * @return the plan
     * @throws ScenarioException with all problems of the files
     */
    public static CampaignPlan read(Path file) throws ScenarioException {
        Path folder = file.toAbsolutePath().getParent();
        return read(file.toString(), file, (number, name) -> readScenario(folder, name));
    }

    private static byte[] readScenario(Path folder, String name) throws ScenarioException {
        try {
            return XmlFile.readBytes(folder.resolve(name), Allowed.SCENARIO_FILE.with());
        } catch (InvalidPathException e) {
            throw new ScenarioException(
                    folder + File.separator + name,
                    FileNameEncoding.lacking(name)
                            .map(ProblemKind.UNENCODABLE_FILE_NAME::with)
                            .orElseGet(ProblemKind.BAD_FILE_NAME::with));
        }
    }

    /**
     * {@return the copy of the plan that a campaign keeps}
     *
     * @param folder the folder that holds {@link #copies}
     * @throws ScenarioException with all problems of the files
     */
    public static CampaignPlan readCopy(Path folder) throws ScenarioException {
        Path file = folder.resolve(COPY);
        return read(
                file.toString(),
                file,
                (number, name) -> XmlFile.readBytes(folder.resolve(copyName(number)), Allowed.SCENARIO_FILE.with()));
    }

    private static CampaignPlan read(String name, Path file, Resolver resolver) throws ScenarioException {
        return PlanReader.read(name, XmlFile.readBytes(file, KIND), resolver);
    }

    /**
     * {@return the name of a scenario in a copy, by its number in the plan, from 1}
     *
     * @param number the number of the scenario in the plan, from 1
     */
    public static String copyName(int number) {
        return "scenario-" + number + ".xml";
    }

    /**
     * {@return the path of the plan, and those of the scenarios as the plan names them, relative to its folder} The
     * scenarios of a copy are read from its own files instead, so there need not be a file at their paths.
     */
    public List<Path> paths() {
        Path file = Path.of(name).toAbsolutePath();
        List<Path> paths = new ArrayList<>(List.of(file));
        for (String scenario : scenarios.keySet()) {
            paths.add(file.resolveSibling(scenario));
        }
        return paths;
    }

    /** {@return the bytes of all files by their names in a copy, the plan first} */
    public Map<String, byte[]> copies() {
        Map<String, byte[]> copies = new LinkedHashMap<>();
        copies.put(COPY, plan);
        int number = 0;
        for (byte[] bytes : scenarios.values()) {
            copies.put(copyName(++number), bytes);
        }
        return copies;
    }
}
