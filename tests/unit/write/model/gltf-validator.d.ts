/** The Khronos validator ships without types; this is what we call. */
declare module 'gltf-validator' {
  export interface ValidationReport {
    readonly issues: {
      readonly numErrors: number;
      readonly numWarnings: number;
      readonly messages: readonly unknown[];
    };
  }
  export function validateBytes(data: Uint8Array): Promise<ValidationReport>;
}
