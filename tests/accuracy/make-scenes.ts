/** Writes scenes of the corpus, in a process of its own: `tsx make-scenes.ts FOLDER NAME…`. */
import { makeScenes } from './corpus-files.ts';

const [folder, ...names] = process.argv.slice(2);
makeScenes(folder, names);
