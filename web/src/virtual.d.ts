declare module "virtual:example-case" {
  const scene: import("./model.ts").Case;
  export default scene;
}

declare module "*.css";
