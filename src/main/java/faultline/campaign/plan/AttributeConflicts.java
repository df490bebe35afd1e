package faultline.campaign.plan;

import faultline.io.MessageText;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Finds attributes that two elements of a plan set, also if one names an element of a scenario by its id and the other
 * by its number. Only one of the values would be effective, and the column of the other one would show values that no
 * run had.
 */
final class AttributeConflicts {

    /** The number of paths, in all worlds together, after which no further world is searched. */
    private static final int MAX_PATHS = 200_000;

    private final ScenarioTree world;
    private final Set<ScenarioChange.SetAttribute> found;
    private final Map<AttributePath, AttributePath> numbered = new HashMap<>();
    private final Set<AttributePath> constant = new HashSet<>();
    private final Set<AttributePath> varied = new HashSet<>();

    /** Creates a finder of conflicts in a world; the changes that set an attribute again are added to a set. */
    private AttributeConflicts(XmlElement world, Set<ScenarioChange.SetAttribute> found) {
        this.world = new ScenarioTree(world);
        this.found = found;
    }

    /**
     * Reports each attribute that is set twice, in worlds of each kind, as long as that takes at most a few seconds.
     * Variants and masks may replace a constant value.
     */
    static void report(
            List<WorldSource> worlds, List<ScenarioChange> constants, List<Factor> factors, Problems problems) {
        Set<ScenarioChange.SetAttribute> found = new LinkedHashSet<>();
        int paths = 0;
        for (WorldSource source : worlds) {
            if (paths >= MAX_PATHS) {
                break;
            }
            AttributeConflicts conflicts = new AttributeConflicts(source.root(0), found);
            constants.forEach(change -> conflicts.add(change, conflicts.constant));
            factors.forEach(conflicts::add);
            paths += conflicts.numbered.size();
        }
        for (ScenarioChange.SetAttribute change : found) {
            String path = MessageText.excerpt(change.path().toString());
            problems.add(change.location(), PlanProblem.DUPLICATE_ATTRIBUTE.with(path));
        }
    }

    private void add(Factor factor) {
        Map<AttributePath, ScenarioChange.SetAttribute> first = new LinkedHashMap<>();
        for (Factor.Level level : factor.settingLevels()) {
            Set<AttributePath> inLevel = new HashSet<>();
            for (ScenarioChange change : level.edits()) {
                if (change instanceof ScenarioChange.SetAttribute set) {
                    add(set, inLevel);
                    first.putIfAbsent(numbered(set), set);
                }
            }
        }
        first.forEach((path, change) -> {
            if (factor.kind() == FactorKind.SET && constant.contains(path)) {
                found.add(change);
            } else {
                add(change, varied);
            }
        });
    }

    private void add(ScenarioChange change, Set<AttributePath> paths) {
        if (change instanceof ScenarioChange.SetAttribute set && !paths.add(numbered(set))) {
            found.add(set);
        }
    }

    private AttributePath numbered(ScenarioChange.SetAttribute change) {
        return numbered.computeIfAbsent(change.path(), world::numbered);
    }
}
